#include "loading/plugin_library.h"
