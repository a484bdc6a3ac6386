#include "numeric/wide.h"

vitrine::Wide wide(double x) { return vitrine::Wide(x); }
