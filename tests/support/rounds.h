/* How often a test that goes on by chance goes on: less often where a sanitizer watches, under which everything takes ten times as
 * long, and where the programs run natively and as WebAssembly to compare their bits (tests/wasm). */
#ifndef BATTEN_TESTS_ROUNDS_H
#define BATTEN_TESTS_ROUNDS_H

#ifdef BATTEN_BITS_COMPARED
enum { FEWER = 1 };
#elif defined __clang__
enum { FEWER = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) };
#else
enum { FEWER = 0 };
#endif

/* Of so many rounds: all, or the first sixth of them. */
#define ROUNDS_OF(all) (FEWER ? ((all) + 5) / 6 : (all))

#endif
