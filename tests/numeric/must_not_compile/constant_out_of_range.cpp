#include "numeric/fixed.h"

const vitrine::FixedUnit kFour(4.0);
