// The one place that names the GL loader.
#pragma once

#include <epoxy/gl.h>
