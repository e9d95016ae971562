#pragma once

// The functions of OpenGL 4.3 core, as exported by the library.
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
