#pragma once

#include "visibility/methods/strong_occlusion/model_2d.hpp"
#include "visibility/methods/strong_occlusion/model_3d.hpp"
