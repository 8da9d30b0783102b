#include "FalconRig.h"
