// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/PlotLabels.h"
#include "tests/Suite.h"

#include <QTest>
#include <random>

using namespace toile;
using namespace toile::study;

class tst_PlotLabels : public QObject {
    Q_OBJECT
private slots:
    void aPointAloneHasItsLabelAbove();
    void ofTwoNeighboursOneHasItBelowOrBeside();
    void oneLabelStandsForPointsThatCoincide();
    void noneLiesOnAnotherOrOnAPoint();
    void whereThereIsNoRoomNoneIsWritten();
};

void tst_PlotLabels::aPointAloneHasItsLabelAbove() {
    const auto places = placedLabels(std::vector<PointLabel>{{{100, 100}, "28"}});
    QVERIFY(places[0] && places[0]->x == 0 && places[0]->y > 0);
}

void tst_PlotLabels::ofTwoNeighboursOneHasItBelowOrBeside() {
    const auto places = placedLabels(std::vector<PointLabel>{{{100, 100}, "28"}, {{104, 103}, "20"}});
    QVERIFY(places[0] && places[1]);
    QVERIFY(places[1]->y <= 0 || places[0]->y <= 0);
}

void tst_PlotLabels::oneLabelStandsForPointsThatCoincide() {
    const auto same = placedLabels(std::vector<PointLabel>{{{100, 100}, "14"}, {{101, 100}, "14"}});
    QVERIFY(same[0] && !same[1]);
    const auto apart = placedLabels(std::vector<PointLabel>{{{100, 100}, "14"}, {{150, 100}, "14"}});
    QVERIFY(apart[0] && apart[1]);
}

void tst_PlotLabels::noneLiesOnAnotherOrOnAPoint() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 150);
    std::vector<PointLabel> labels;
    for (int i = 0; i < 30; ++i) labels.push_back({{place(random), place(random)}, std::to_string(10 + i)});
    const LabelRoom room;
    const auto places = placedLabels(labels, room);
    const double halfX = room.character.x, halfY = room.character.y / 2; // two characters
    int written = 0;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!places[i]) continue;
        ++written;
        const Vec2 middle = labels[i].point + *places[i];
        for (std::size_t k = 0; k < labels.size(); ++k) {
            const Vec2 toPoint = labels[k].point - middle;
            QVERIFY(std::abs(toPoint.x) >= halfX + room.marker || std::abs(toPoint.y) >= halfY + room.marker);
            if (k == i || !places[k]) continue;
            const Vec2 toLabel = labels[k].point + *places[k] - middle;
            QVERIFY(std::abs(toLabel.x) >= 2 * halfX || std::abs(toLabel.y) >= 2 * halfY);
        }
    }
    QVERIFY2(written >= 25, qPrintable(QString::number(written)));
}

void tst_PlotLabels::whereThereIsNoRoomNoneIsWritten() {
    std::vector<PointLabel> labels;
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) labels.push_back({{4.0 * x, 4.0 * y}, std::to_string(100 + 20 * x + y)});
    const auto places = placedLabels(labels);
    QVERIFY(!places[20 * 10 + 10]);
}

TOILE_TEST(tst_PlotLabels)
#include "tst_PlotLabels.moc"
