#version 450
// Writes VALUE, four components made of one built-in: a module a built-in, because the mere presence of SampleId or SamplePosition
// changes how often a fragment shader runs.
// ALPHA: output 0 takes the first varying, whose alpha makes coverage, and the built-in comes after it.

#ifdef ALPHA
layout(location = 0) in vec4 in0;
layout(location = 0) out vec4 alpha;
layout(location = 1) out vec4 value;
#else
layout(location = 0) out vec4 value;
#endif

void main() {
#ifdef ALPHA
  alpha = in0;
#endif
  value = VALUE;
}
