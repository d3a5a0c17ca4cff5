#include "simulation/compiled_model.h"
