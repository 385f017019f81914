// The colours of heat maps.
#include "shared/viridis.h"

// The colour of a value, 0..1; others count as the nearer bound.
vec3 viridis(float t) {
  const vec3 points[VIRIDIS_POINTS] = vec3[](vec3(VIRIDIS_0), vec3(VIRIDIS_1), vec3(VIRIDIS_2),
                                             vec3(VIRIDIS_3), vec3(VIRIDIS_4));
  float x = clamp(t, 0.0, 1.0) * float(VIRIDIS_POINTS - 1);
  int i = min(int(x), VIRIDIS_POINTS - 2);
  return mix(points[i], points[i + 1], x - float(i));
}
