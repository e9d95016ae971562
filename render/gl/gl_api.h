#pragma once

// The functions of OpenGL 4.3 core as the library exports them.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
