/* Converts between doubles and decimal digits, correctly rounded both ways; no locale, no printf, no strtod. */
#ifndef BATTEN_TEXT_DIGITS_H
#define BATTEN_TEXT_DIGITS_H

/* The `count` leading digits ('0' to '9', not zero-terminated) of a finite value > 0, as d.ddd * 10^power,
 * rounded half to even. A count above 17 gives 17 digits. The second call rounds to `places` digits after the
 * point instead, and returns how many digits that makes (at most 17, and 0 when the value rounds to zero). */
void bat_digits_leading(double value, int count, char *digits, int *power);
int bat_digits_places(double value, int places, char *digits, int *power);

/* The fewest digits, without trailing zeros, that read back as a value > 0, of those that are its nearest with 15, 16 or 17; they
 * mean d.ddd * 10^power. Returns how many; 0: the value is so large, small or even that bat_digits_leading has to be asked. */
int bat_digits_shortest(double value, char *digits, int *power);

/* The double nearest to digits[0..n) * 10^exponent, ties to even; n is at most BAT_DIGITS_MOST, digits[0] != '0'. */
double bat_digits_value(const char *digits, int n, long exponent);

enum { BAT_DIGITS_MOST = 816 };

#endif
