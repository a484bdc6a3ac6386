#include "numeric/fixed.h"

vitrine::FixedUnit four() { return vitrine::FixedUnit(4.0); }
