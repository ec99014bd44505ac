// Calls into every library of the package, and through them into everything that they are linked with.
#include <apps/common/progress.h>
#include <apps/cutlocus/cutlocus.h>
#include <apps/cutlocus/picture/svg_chart.h>
#include <apps/cutlocus/report.h>
#include <core/parallel.h>
#include <dsc2d/deform/deformer.h>
#include <dsc2d/generate/insert_polygon.h>
#include <dsc2d/generate/structured.h>
#include <dsc2d/validate.h>
#include <geodesic/expression_metric.h>
#include <geodesic/geodesic_flow.h>
#include <geodesic/torus.h>
#include <geometry/predicates.h>
#include <io/html_view.h>
#include <motion/expression_field.h>
#include <surface/sizing.h>

#include <cmath>
#include <iostream>
#include <optional>
#include <vector>

namespace {

int failures = 0;

void check(bool condition, const char* what) {
    if (condition) return;
    ++failures;
    std::cout << "failed: " << what << '\n';
}

void small_libraries() {
    std::vector<double> squares(1000);
    dsc::core::parallel_for(squares.size(), {.threads = 2, .grain = 10}, [&](std::size_t i) { squares[i] = i * i; });
    check(squares.back() == 998'001, "core");
    const Eigen::Vector2d a(0.1, 0.1), b(0.3, 0.3), c(0.7, 0.7);  // collinear: for the exact predicate
    check(dsc::geometry::orientation(a, b, c) == dsc::geometry::Sign::zero, "geometry");
    check(dsc::io::html_page({}).size() > 100'000, "io");
}

void move_and_measure_a_surface() {
    using namespace dsc::motion;
    const auto turn = expression_field<2>("(-y, x)");
    check(turn({1, 2}, 0) == Vector<2>(-2, 1), "motion");
    dsc::geometry::SurfaceData tetrahedron;
    tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    dsc::surface::SizingParameters sizing{.length = 1, .min_length = 0.01};
    sizing.edges_across = 2;
    check(dsc::surface::wanted_lengths(tetrahedron, sizing).size() == 4, "surface");
}

void deform_a_square() {
    using namespace dsc::dsc2d;
    Complex complex = structured_complex(Domain::box({0, 0}, {1, 1}), 8, 8);
    const std::vector<Point2> square{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    const auto corners = insert_polygon(complex, square, 1);
    Parameters parameters;
    parameters.edge_length = 0.1;
    Deformer deformer(complex, parameters);
    std::vector<std::optional<Point2>> targets(complex.vertex_capacity());
    for (const VertexId v : corners) targets[v.index()] = complex.position(v) + Point2(0.01, 0);
    check(deformer.step(targets).is_complete && validate(complex).empty(), "dsc2d and motion");
}

void shoot_a_geodesic() {
    using namespace dsc::geodesic;
    const ExpressionMetric sphere("E=cos(v)^2; F=0; G=1", {}, "--metric");
    GeodesicFlow flow(sphere, {0, 0});
    check(std::abs(flow.shoot(0, 1).x.x() - 1) < 1e-12, "geodesic");
}

void find_a_cut_locus(dsc::core::Observer& observer) {
    using namespace dsc::cutlocus;
    const dsc::geodesic::TorusOfRevolution torus(2, 2);
    const CutLocus locus = cut_locus(torus, {0, 0}, {}, observer);
    check(locus.graph.certificate.holds() && locus.graph.vertices.size() == 8, "cutlocus");
    check(!locus_summary(torus, {}, locus, 0).empty(), "the report of cutlocus");
    check(svg_chart(torus, {0, 0}, locus).ends_with("</svg>\n"), "the picture of cutlocus");
}

}  // namespace

int main() {
    small_libraries();
    move_and_measure_a_surface();
    deform_a_square();
    shoot_a_geodesic();
    dsc::apps::ProgressObserver observer(dsc::apps::ProgressMode::none);
    find_a_cut_locus(observer);
    std::cout << (failures == 0 ? "every library answers\n" : "not every library answers\n");
    return failures == 0 ? 0 : 1;
}
