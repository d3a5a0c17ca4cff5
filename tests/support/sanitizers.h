#pragma once

/// LACUNA_WATCHED is 1 in a build with the address or the thread sanitizer, which bring an allocator and a loader of
/// their own; GCC and clang say so in different ways.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LACUNA_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LACUNA_WATCHED 1
#endif
#endif
#ifndef LACUNA_WATCHED
#define LACUNA_WATCHED 0
#endif
