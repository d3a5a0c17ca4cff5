#include "measurement/recording.h"
