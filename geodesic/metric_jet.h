// SPDX-License-Identifier: GPL-3.0-or-later
// From partial derivatives to geometry: Christoffel symbols, Gaussian curvature and their derivatives from the numbers
// of an embedding r(u, v) or of E, F, G and of their partial derivatives up to order 3. Thesis 5.2.3 and 5.4.2;
// Gauss' equation in Brioschi's form.
// Guarantee: exact formulas, no differences. Cost: some 150 multiplications, no allocation.
#pragma once

#include "geodesic/metric.h"

namespace dsc::geodesic {

/// A function of (u, v) at a point, with all partial derivatives up to order 3.
struct ScalarJet {
    double value = 0;
    double u = 0, v = 0;
    double uu = 0, uv = 0, vv = 0;
    double uuu = 0, uuv = 0, uvv = 0, vvv = 0;
};

/// What both kinds of surface boil down to. By Gauss' equation, with g⁻¹ the inverse of the tensor and the Christoffel
/// symbols of the first kind seen as covectors [uu], [uv], [vv]:
///   K (EG - F²) = gauss - g⁻¹([uu], [vv]) + g⁻¹([uv], [uv]).
struct MetricJet {
    /// One of E, F, G with its partial derivatives up to order 2.
    struct Component {
        double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    };
    Component E, F, G;
    double gauss = 0, gauss_u = 0, gauss_v = 0;  ///< F_uv - (E_vv + G_uu)/2, and its derivatives
};

/// From the three coordinates of an embedding: gauss = r_uu·r_vv - r_uv·r_uv, in which the derivatives of order 3 have
/// cancelled, so that order 3 is enough for the gradient of K.
MetricJet embedding_jet(const ScalarJet& x, const ScalarJet& y, const ScalarJet& z);

/// From the jets of E, F and G themselves.
MetricJet tensor_jet(const ScalarJet& E, const ScalarJet& F, const ScalarJet& G);

LocalGeometry local_geometry(const MetricJet& jet);
/// Uses E, F, G up to order 2 only.
ConnectionJet connection_jet(const MetricJet& jet);

}  // namespace dsc::geodesic
