// Nothing of its own: it carries the precompiled headers of precompiled_headers.cmake.
