// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/InPlace.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double step = 1.0 / 60;

/// How long it has been in place after so many frame steps of a particle there, beside one that lies.
template <class Place>
double inPlaceAfter(int frames, const Place& placeAt) {
    InPlace inPlace;
    double time = 0;
    for (int frame = 0; frame < frames; ++frame) time = inPlace.note(std::vector{Vec3{1, 2, 3}, placeAt(frame)}, step);
    return time;
}

} // namespace

/// What goes nowhere, however fast it is.
class tst_InPlace : public QObject {
    Q_OBJECT
private slots:
    void whatTremblesIsInPlace() {
        const double time = inPlaceAfter(61, [](int frame) { return Vec3{frame % 2 ? 0.0004 : 0, 0, 0}; }); // 24 mm/s
        QVERIFY(std::abs(time - 1) < 1e-12);
    }
    void whatCreepsIsNot() {
        const double time = inPlaceAfter(600, [](int frame) { return Vec3{0, 0, 0.002 * step * frame}; }); // 2 mm/s
        QVERIFY(time < 0.26);
    }
    /// Once in a second to and fro by 1 mm: at its turning points as well.
    void whatSwingsIsNot() {
        InPlace inPlace;
        for (int frame = 0; frame < 600; ++frame) {
            const double angle = 2 * std::numbers::pi * step * frame;
            QVERIFY(inPlace.note(std::vector{Vec3{0, 0.001 * std::sin(angle), 0}}, step) < 0.5);
        }
    }
    void anotherClothBeginsAnew() {
        InPlace inPlace;
        inPlace.note(std::vector<Vec3>(3), step);
        QCOMPARE(inPlace.note(std::vector<Vec3>(3), step), step);
        QCOMPARE(inPlace.note(std::vector<Vec3>(2), step), 0.0);
        inPlace.note(std::vector<Vec3>(2), step);
        inPlace.forget();
        QCOMPARE(inPlace.note(std::vector<Vec3>(2), step), 0.0);
    }
};

TOILE_TEST(tst_InPlace)
#include "tst_InPlace.moc"
