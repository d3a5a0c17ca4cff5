// Nothing of its own: it carries the precompiled headers of lacuna_build.cmake.
