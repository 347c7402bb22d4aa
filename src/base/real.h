/*
 * Internal to the library: elementary functions that give the same bits everywhere. IEEE 754 fixes + - * / and
 * sqrt; it does not fix hypot, exp, sin and similar functions, and glibc and the WASM libc differ in their last
 * bits. A journal must replay to the same document natively and in the browser, so the library calls these
 * instead. From libm only the exact ones are used: sqrt, fabs, floor, ceil, trunc, round, rint, fmod, remainder,
 * fmin, fmax, copysign, frexp, ldexp, nextafter.
 *
 * Special values (NaN, infinities, signed zeros, domain errors) are as in C17 annex F. Errors are measured in
 * units in the last place against long double by tests/base/test_real.c.
 */
#ifndef BATTEN_BASE_REAL_H
#define BATTEN_BASE_REAL_H

#include <float.h>

/* 1: floats are computed as doubles, and these as they are. */
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1
#error "Batten needs doubles without excess precision; on 32-bit x86: -msse2 -mfpmath=sse"
#endif
#ifdef __FAST_MATH__
#error "Batten needs IEEE 754 arithmetic: no -ffast-math, no -Ofast"
#endif

#define BAT_PI 3.14159265358979323846

double bat_hypot(double x, double y); /* 1.25 ulp; no overflow or underflow on the way */
double bat_exp(double x);             /* 2 ulp */
double bat_log(double x);             /* 2 ulp */
double bat_sin(double x);  /* 2 ulp of 1 for |x| < 1e6; beyond that also the rounding of the period */
double bat_cos(double x);  /* as sin */
double bat_tan(double x);  /* sin / cos */
double bat_atan(double x); /* 2 ulp */
double bat_atan2(double y, double x); /* 2 ulp */
double bat_acos(double x);            /* 3 ulp of pi */
double bat_asin(double x);            /* 4 ulp */

#endif
