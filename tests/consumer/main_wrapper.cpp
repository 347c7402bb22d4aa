// The C++ wrapper: what it returns against closed forms, what it refuses, what it frees (run under a leak checker too).
#include <batten/batten.hpp>
#include <batten/names.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace {
int faults = 0;

void expect(bool holds, const char *what) {
    if (holds) return;
    std::printf("not so: %s\n", what);
    faults++;
}

template <class Call> bat_status refused(Call call) {
    try {
        call();
    } catch (const bat::Error &e) {
        return e.status();
    }
    return BAT_OK;
}

std::vector<double> circle(double radius, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; i++) {
        const double turn = 6.283185307179586 * i / count;
        out.push_back(radius * std::cos(turn));
        out.push_back(radius * std::sin(turn));
    }
    return out;
}

void curves() {
    const std::vector<double> control{0, 0, 1, 0, 1, 1},
        knots{0, 0, 0, 1, 1, 1}; // a parabola: (2u - u^2, u^2)
    const bat::Curve parabola = bat::curve(control, knots, 2, 2);
    const auto at = parabola.at(0.25, 1);
    expect(at.size() == 4 && at[0] == 0.4375 && at[1] == 0.0625 && at[2] == 1.5 && at[3] == 0.5,
           "position and derivative");
    expect(parabola == bat::clamped(control, 2, 2), "uniform knots are these");
    expect(parabola == bat::read_curve(parabola.write()), "written and read");
    const bat::Curve finer = parabola.insert_knot(0.5);
    expect(finer.count() == 4 && finer.at(0.3) == parabola.at(0.3), "a knot more, the same curve");
    expect(finer.simplify(1e-9).out.count() == 3, "and without it again");
    const auto [left, right] = parabola.split(0.5);
    expect(left.at(0.5) == right.at(0.5) && left.domain()[1] == 0.5, "split");
    const bat_near near = parabola.nearest({1, 1});
    expect(near.distance == 0 && near.u == 1, "the closest point of an end");
    expect(parabola.to_cubics().size() == 8, "one cubic");
    expect(parabola.transform({0, -1, 0, 1, 0, 0}).points()[2] == 0, "a quarter turn");
    const auto frames = parabola.frames_at(parabola.spread(3)).frames;
    expect(frames.size() == 3 && frames[1].t[0] * frames[1].s[0] + frames[1].t[1] * frames[1].s[1] == 0,
           "frames");
    const bat::Curve ring = bat::interpolate(circle(5, 64), 2, true);
    expect(ring.closed() && std::fabs(ring.length() - 31.41592653589793) < 1e-4, "length of a circle");
    const std::vector<double> places{0, 0, 2, 0}, directions{0, 1, 0, -1};
    const bat::Curve spline = bat::spline({2, false, 2, places.data(), directions.data(), nullptr}).out;
    const auto start = spline.at(spline.domain()[0], 1);
    expect(start[2] == 0 && start[3] > 0, "directions are kept");
}

void hands() {
    const auto points = circle(10, 100);
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 0.05;
    const auto fitted = bat::fit(points, &options);
    expect(fitted.within && fitted.report.max_error <= 0.05, "a fit within its tolerance");
    bat::LiveSketch pen = bat::live();
    for (int i = 0; i <= 60; i++) pen.add_many(bat::Stroke{{4.0 * i, 40 * std::sin(i / 15.0)}});
    expect(pen.preview().out.count() >= 4, "a preview");
    std::vector<double> drawn;
    for (int i = 0; i <= 60; i++) drawn.insert(drawn.end(), {4.0 * i, 40 * std::sin(i / 15.0)});
    const auto live = pen.commit();
    const auto once = bat::sketch(bat::Stroke{drawn});
    expect(live.out == once.out, "live and in one call: the same curve");
    bat::Shape shape = once.out.levels(1);
    const double middle = (once.out.domain()[0] + once.out.domain()[1]) / 2;
    shape.drag(0, middle, {0, 5});
    expect(shape.levels() == 1 && shape.flatten().count() == once.out.count(), "levels");
    expect(shape.details(1).size() == 3 * shape.nodes(1).size(), "details");
}

void drawings() {
    bat::Editor editor;
    std::vector<std::string> names;
#define NAME(id, name, keys) names.emplace_back(name);
    BAT_EACH_COMMAND(NAME)
    for (const auto &name : names) {
        const bat_status status = refused([&] { editor.command(name); });
        expect(status == BAT_OK || status == BAT_STATE, name.c_str());
    }
    expect(names.size() > 150, "names of commands");
    names.clear();
#define PROPERTY(id, name, standard, low, high) names.emplace_back(name);
    BAT_EACH_PROPERTY(PROPERTY)
    for (const auto &name : names) {
        double value = 0;
        const bat_status status = bat_editor_get(editor.get(), name.c_str(), &value);
        expect(status == BAT_OK || status == BAT_STATE, name.c_str()); // some are of a picture alone
    }
    expect(refused([&] { editor.command("no-such-command"); }) == BAT_UNSUPPORTED, "no such command");
    const bat::Document empty = bat::document();
    expect(empty.to_svg().find("<svg") != std::string::npos && bat::read_document(empty.write()).count() == 0,
           "a document");
    expect(editor.frame() != nullptr, "a frame");
}

void refusals() {
    const std::vector<double> control{0, 0, 1, 1}, odd{0, 0, 1}, knots{0, 0, 1, 1};
    const bat::Curve line = bat::curve(control, knots, 2, 1);
    expect(refused([&] { (void)bat::curve(odd, knots, 2, 1); }) == BAT_COUNT, "half a point");
    expect(refused([&] { (void)bat::curve(control, odd, 2, 1); }) == BAT_KNOTS, "too few knots");
    expect(refused([&] { (void)line.split(2); }) == BAT_PARAMETER, "a cut outside");
    expect(refused([&] { (void)bat::fit({}); }) == BAT_ARGUMENT, "no points");
    expect(refused([&] { (void)bat::read_curve("{"); }) == BAT_SYNTAX, "no curve");
    expect(refused([&] { (void)line.at(0.5, -1); }) == BAT_ARGUMENT, "a negative order");
    expect(refused([&] { line.shape().drag(3, 0.5, {0, 1}); }) == BAT_ARGUMENT, "no such level");
    bat::LiveSketch pen = bat::live();
    expect(refused([&] { (void)pen.commit(); }) != BAT_OK && refused([&] { pen.add_many(bat::Stroke{{1, 2}}); }) == BAT_ARGUMENT,
           "a session that has ended");
}
} // namespace

int main() {
    static_assert(std::is_nothrow_move_constructible_v<bat::Curve> &&
                  !std::is_copy_constructible_v<bat::Curve>);
    curves(), hands(), drawings(), refusals();
    return faults == 0 ? 0 : 1;
}
