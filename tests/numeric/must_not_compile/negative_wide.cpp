#include "numeric/wide.h"

vitrine::Wide negative() { return vitrine::Wide(-1.0); }
