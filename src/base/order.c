#include "base/order.h"

double bat_middle(const double *numbers, size_t count) {
    double some[101];
    const size_t n = count < 101 ? count : 101;
    for (size_t i = 0; i < n; i++) {
        const double next = numbers[i * count / n];
        size_t k = i;
        for (; k > 0 && some[k - 1] > next; k--) some[k] = some[k - 1];
        some[k] = next;
    }
    return n ? some[n / 2] : 0;
}
