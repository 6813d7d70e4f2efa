// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/Mannequin.h"
#include "core/body/Measuring.h"
#include "tests/Suite.h"
#include "tests/body/SampleMeasurements.h"

#include <QTest>
#include <cmath>

using namespace toile;
using namespace toile::body;

/// What the tape finds on a mannequin is what the mannequin was asked for.
class tst_Measuring : public QObject {
    Q_OBJECT
private slots:
    void aMannequinMeasuresWhatWasAsked_data();
    void aMannequinMeasuresWhatWasAsked();
    void aBodyWithoutLimbsIsRefused();
};

void tst_Measuring::aMannequinMeasuresWhatWasAsked_data() {
    QTest::addColumn<double>("bust");
    QTest::newRow("of the sample's size") << 0.90;
    QTest::newRow("of a fuller bust") << 0.98;
}

void tst_Measuring::aMannequinMeasuresWhatWasAsked() {
    QFETCH(double, bust);
    Measurements asked;
    asked.bust = bust;
    const auto mannequin = makeMannequin(asked);
    QVERIFY(mannequin);
    const auto found = measurementsOf(mannequin->body);
    QVERIFY2(found, found ? "" : toString(found.error()).c_str());
    const auto near = [](double a, double b, double tolerance, const char* name) {
        if (std::abs(a - b) < tolerance) return true;
        qWarning("%s: %.1f mm instead of %.1f", name, 1000 * a, 1000 * b);
        return false;
    };
    constexpr double tape = 0.005; // [m]; the promise for girths, andlengths between landmarks
    bool all = true;
    for (const auto& [name, member, tolerance] : {std::tuple{"height", &Measurements::height, 0.005},
                                                  {"bust", &Measurements::bust, tape},
                                                  {"underBust", &Measurements::underBust, tape},
                                                  {"waist", &Measurements::waist, tape},
                                                  {"hip", &Measurements::hip, tape},
                                                  {"neck", &Measurements::neck, tape},
                                                  {"biceps", &Measurements::biceps, tape},
                                                  {"wrist", &Measurements::wrist, tape},
                                                  {"thigh", &Measurements::thigh, tape},
                                                  {"shoulderWidth", &Measurements::shoulderWidth, 0.001},
                                                  {"shoulderSlope", &Measurements::shoulderSlope, 0.02},
                                                  {"napeToWaist", &Measurements::napeToWaist, 0.001},
                                                  {"bustHeight", &Measurements::bustHeight, 0.003},
                                                  {"arm", &Measurements::arm, 0.003},
                                                  {"insideLeg", &Measurements::insideLeg, 0.003},
                                                  {"armAngle", &Measurements::armAngle, 0.02}})
        all = near((*found).*member, asked.*member, tolerance, name) && all;
    QVERIFY(all);
}

void tst_Measuring::aBodyWithoutLimbsIsRefused() {
    QVERIFY(!measurementsOf(Body{"nothing", {}, {}, {}}));
}

TOILE_TEST(tst_Measuring)
#include "tst_Measuring.moc"
