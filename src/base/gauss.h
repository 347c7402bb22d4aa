/* Internal to the library: Gauss-Legendre quadrature, eight nodes: exact for polynomials of degree 15. */
#ifndef BATTEN_BASE_GAUSS_H
#define BATTEN_BASE_GAUSS_H

typedef double bat_integrand(const void *context, double u);

static inline double bat_gauss(bat_integrand *f, const void *context, double a, double b) {
    static const double node[4] = {0.1834346424956498049394761, 0.5255324099163289858177390,
                                   0.7966664774136267395915539, 0.9602898564975362316835609};
    static const double weight[4] = {0.3626837833783619829651504, 0.3137066458778872873379622,
                                     0.2223810344533744705443560, 0.1012285362903762591525314};
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    double sum = 0;
    for (int i = 0; i < 4; i++)
        sum += weight[i] * (f(context, middle - half * node[i]) + f(context, middle + half * node[i]));
    return sum * half;
}

#endif
