// The same from C++: the headers have C linkage there, and a curve fits a unique_ptr.
#include <batten/batten.h>

#include <iostream>
#include <memory>
#include <string>

struct Free {
    void operator()(bat_curve *curve) const { bat_curve_free(curve); }
};

int main() {
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 2, 4};
    bat_curve *raw = nullptr;
    if (bat_curve_create(2, 1, false, 2, points, 4, knots, &raw) != BAT_OK) return 1;
    std::unique_ptr<bat_curve, Free> line(raw);
    double middle[2];
    bat_curve_eval(line.get(), 0.5, 0, middle);
    std::cout << bat_version() << " " << middle[0] << " " << middle[1] << "\n";
    return std::string(bat_version()) == BAT_VERSION && middle[0] == 1 && middle[1] == 2 ? 0 : 1;
}
