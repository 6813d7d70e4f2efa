// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/BlockCholesky.h"
#include "core/dynamics/Eliminated.h"
#include "tests/validation/Case.h"

using namespace toile;
using namespace toile::fixtures;
using namespace toile::validation;

namespace {

constexpr double length = 0.1, bending = 5e-5; // [m], [N·m]
constexpr double modulus = 1e4, shear = 100;   // [N/m]
constexpr int cells = 32;
constexpr double h = length / cells;

/// A strip that stands on two clamped rows of nodes at y = −h and 0.
struct Column {
    Patch patch;
    ClothModel model;
};

Column column() {
    Fabric fabric = wovenFabric();
    fabric.warpStiffness = fabric.weftStiffness = modulus;
    fabric.shearStiffness = shear;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = bending;
    std::vector<double> rows;
    for (int j = -1; j <= cells; ++j) rows.push_back(j * h);
    Column c{gridPatch(evenLines(h, 1), rows), {}};
    c.model = modelOf(c.patch, fabric);
    c.model.pinned = {0, 1, 2, 3};
    cloth::doubleBendingAtClampedRows(c.model);
    return c;
}

/// The straight strip compressed by what stands above each height is no energy minimum any more once it buckles: the
/// exact Hessian loses its definiteness. compression(y): strain along y.
bool buckles(const Column& c, auto compression) {
    std::vector<Vec3> x = flatPositions(c.patch);
    for (std::size_t p = 4; p < x.size(); p += 2) {
        const double middle = 0.5 * (c.patch.material[p].y + c.patch.material[p - 2].y);
        const double strain = compression(middle);
        x[p].y = x[p + 1].y = x[p - 2].y + h * (1 - strain);
        x[p + 1].x = h * (1 + strain * shear / modulus); // free sides
    }
    const dynamics::Eliminated eliminated(c.model);
    struct Sink : cloth::HessianSink {
        const dynamics::Eliminated& eliminated;
        dynamics::BlockCholesky& matrix;
        Sink(const dynamics::Eliminated& e, dynamics::BlockCholesky& m) : eliminated(e), matrix(m) {}
        void add(int i, int j, const double (&block)[9]) override {
            const int row = eliminated.unknownOf(i), col = eliminated.unknownOf(j);
            if (row >= 0 && col >= 0) matrix.add(row, col, block);
        }
    };
    dynamics::BlockCholesky matrix(eliminated.count());
    Sink sink(eliminated, matrix);
    cloth::addHessian(c.model, x, cloth::HessianForm::exact, sink);
    return !matrix.factorize(std::vector<double>(eliminated.count(), 0.0));
}

/// The smallest load at which it buckles, between two that enclose it.
double criticalLoad(double low, double high, auto bucklesAt) {
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (bucklesAt(middle) ? high : low) = middle;
    }
    return low;
}

} // namespace

class tst_BucklingCases : public QObject {
    Q_OBJECT

private slots:
    void v11EulerBuckling() {
        const Column c = column();
        const double load = criticalLoad(0, 1, [&](double p) { return buckles(c, [p](double) { return p / modulus; }); });
        const double expected = std::numbers::pi * std::numbers::pi * bending / (4 * length * length);
        QVERIFY(caseWithin("V11", "clamped–free strip, edge load, 32 cells", expected, load, 0.02));
    }

    void v12SelfBuckling() {
        const Column c = column();
        const double load = criticalLoad(0, 10, [&](double weight) { // ρg [N/m²]
            return buckles(c, [weight](double y) { return weight * (length - y) / modulus; });
        });
        QVERIFY(caseWithin("V12", "standing strip, ρgL³/B, 32 cells", 7.83735, load * length * length * length / bending, 0.02));
    }
};

QTEST_APPLESS_MAIN(tst_BucklingCases)
#include "tst_BucklingCases.moc"
