#include "numeric/fixed.h"

vitrine::FixedUnit half(double x) { return vitrine::FixedUnit(x); }
