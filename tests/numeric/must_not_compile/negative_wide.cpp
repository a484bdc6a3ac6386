#include "numeric/wide.h"

const vitrine::Wide kNegative(-1.0);
