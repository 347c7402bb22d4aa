/* Whether a sanitizer watches, under which everything takes ten times as long, and how often a test that goes on by chance then goes on. */
#ifndef BATTEN_TESTS_SANITIZED_H
#define BATTEN_TESTS_SANITIZED_H

#ifdef __clang__
enum { SANITIZED = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) };
#else
enum { SANITIZED = 0 };
#endif

/* Of so many rounds: all, or the first sixth of them under a sanitizer, which looks at memory and not at values. */
#define ROUNDS_OF(all) (SANITIZED ? ((all) + 5) / 6 : (all))

#endif
