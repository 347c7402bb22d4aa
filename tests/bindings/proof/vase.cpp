// A surface through three rings, bent by a wire, as triangles in an STL file. Usage: vase vase.stl
#include <batten/batten.hpp>

#include <cstdio>
#include <fstream>

static bat::Curve ring(double size, double height) {
    std::vector<double> points;
    for (const auto &[x, y] : {std::pair{2, 0}, {2, 2}, {0, 2}, {-2, 2}, {-2, 0}, {-2, -2}, {0, -2}, {2, -2}})
        points.insert(points.end(), {size * x, size * y, height});
    return bat::curve(points, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 3, 3, true);
}

int main(int, char **argv) {
    const bat::Surface vase = bat::loft({ring(5, 0), ring(3, 10), ring(6, 20)}).out;

    const bat::Curve straight = bat::clamped({0, 0, 0, 0, 0, 7, 0, 0, 13, 0, 0, 20}, 3);
    const bat::Curve bent = bat::clamped({0, 0, 0, 0, 0, 7, 4, 0, 13, 8, 0, 20}, 3);
    bat_wire wire{};
    wire.reference = straight.get(), wire.scale.constant = 1, wire.radius.constant = 50;
    const std::vector<double> points = vase.points();
    const auto [moved, report] = bat::bind({wire}, points).apply({bent}, points);

    const std::array degree{vase.degree(BAT_U), vase.degree(BAT_V)};
    const std::array closed{vase.is_closed(BAT_U), vase.is_closed(BAT_V)};
    const std::array count{vase.count(BAT_U), vase.count(BAT_V)};
    const auto u = vase.knots(BAT_U), v = vase.knots(BAT_V);
    const std::array knots{static_cast<int>(u.size()), static_cast<int>(v.size())};
    bat::Surface surface = bat::surface(degree, closed, count, moved, knots, u, v);

    std::ofstream(argv[1], std::ios::binary) << bat::write_stl(bat::Model(surface), 0.05);
    std::printf("%zu by %zu points, %zu moved\n", count[0], count[1], report.moved);
}
