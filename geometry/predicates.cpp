// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace dsc::geometry::detail {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 to_cgal(const Point2& p) { return {p.x(), p.y()}; }

Kernel::Point_3 to_cgal(const Point3& p) { return {p.x(), p.y(), p.z()}; }

Sign to_sign(int sign) { return sign > 0 ? Sign::positive : sign < 0 ? Sign::negative : Sign::zero; }

}  // namespace

Sign exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
    return to_sign(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c)));
}

Sign exact_in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    return to_sign(CGAL::side_of_oriented_circle(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

Sign exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return to_sign(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

}  // namespace dsc::geometry::detail
