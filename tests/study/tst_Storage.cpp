// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Storage.h"
#include "samples/CircleSkirt.h"
#include "samples/SmallScenes.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;

namespace {

/// Its middle 0.6 times as wide: no border node is finer for it.
const study::FineBox middle{.piece = "Sheet", .left = 0.2, .bottom = 0.2, .right = 0.8, .top = 0.8};

/// A square sheet of 0.4 m at 40 mm: 10 × 10 cells.
pattern::Pattern sheet() {
    return samples::squareSheet(samples::SheetPins::oneEdge, 0.4, 0.04).pattern;
}

} // namespace

class tst_Storage : public QObject {
    Q_OBJECT
private slots:
    void theMiddleOfASheetAtHalfItsSpacing();
    void aClothTakesLessThan400BytesACell();
    void boxesAreRefusedByName();
    void theTextSaysWhatWasMeasured();
};

void tst_Storage::theMiddleOfASheetAtHalfItsSpacing() {
    const auto painted = study::withFineBoxes(sheet(), {middle});
    QVERIFY2(painted, painted ? "" : toString(painted.error()).c_str());
    const auto study = study::studyStorage(*painted);
    QVERIFY2(study, study ? "" : toString(study.error()).c_str());
    QCOMPARE(study->coarse.nodes, 11 * 11);
    QCOMPARE(study->fine.nodes, 21 * 21);
    QCOMPARE(study->regions.nodes, 11 * 11 - 7 * 7 + 13 * 13);
    QCOMPARE(study->regions.slaves, 4 * 6); // one on each coarse side of the joint
    QCOMPARE(study->regions.cells, 10 * 10 - 6 * 6 + 12 * 12);
    QCOMPARE(study->fine.springs, 2 * 20 * 21 + 2 * 20 * 20);
    QVERIFY(std::abs(study->fineShare - 0.36) < 1e-12);
    QVERIFY(std::abs(study::idealShare(*study) - (0.36 + 0.64 * 121 / 441)) < 1e-12);
    QCOMPARE(study->coarse.spacing, 0.04);
    QCOMPARE(study->regions.spacing, 0.02);
}

void tst_Storage::aClothTakesLessThan400BytesACell() {
    // The goal of meshing.md, for rectangles with springs, bending and twist, and a mesh for display.
    const auto painted =
        study::withFineBoxes(samples::squareSheet(samples::SheetPins::oneEdge, 1.0, 0.01).pattern, {middle});
    QVERIFY(painted);
    const auto study = study::studyStorage(*painted);
    QVERIFY(study);
    const study::StorageLayout& regions = study->regions;
    QVERIFY(regions.springs > 0 && regions.bending > 0 && regions.slaves > 0);
    QCOMPARE(regions.cells, 100 * 100 - 60 * 60 + 120 * 120);
    QVERIFY2((regions.meshBytes + regions.clothBytes) / regions.cells <= 400,
             qPrintable(QString::number((regions.meshBytes + regions.clothBytes) / regions.cells)));
}

void tst_Storage::boxesAreRefusedByName() {
    const auto missing = study::withFineBoxes(sheet(), {{.piece = "Sleeve"}});
    QVERIFY(!missing && missing.error().text.find("\"Sleeve\"") != std::string::npos);
    const auto flat = study::withFineBoxes(sheet(), {{.piece = "Sheet", .left = 0.7, .right = 0.7}});
    QVERIFY(!flat);
    QCOMPARE(flat.error().place.object, std::string("piece \"Sheet\""));
    const auto none = study::studyStorage(sheet());
    QVERIFY(!none && none.error().text.find("no region") != std::string::npos);
    pattern::Pattern pair = sheet();
    pattern::Piece twin = *pair.pieces[0];
    twin.name = "Twin";
    twin.mirror = pattern::MirrorOf{twin.id};
    twin.id = pattern::PieceId("twin");
    pair.pieces.push_back(twin);
    const auto mirrored = study::withFineBoxes(pair, {{.piece = "Twin"}});
    QVERIFY(!mirrored && mirrored.error().text.find("paint that one") != std::string::npos);
}

void tst_Storage::theTextSaysWhatWasMeasured() {
    const auto study = study::studyStorage(*study::withFineBoxes(sheet(), {middle}));
    QVERIFY(study);
    const std::string text =
        study::storageText(*study, "sheet.toile", {.command = "toile-cli study storage sheet.toile"});
    for (const char* words : {"# Storage: sheet.toile", "`toile-cli study storage sheet.toile`",
                              "| regions | 20 | 241 | 24 | 208 |", "36 % of the area is finer", "0.55 times the nodes"})
        QVERIFY2(text.find(words) != std::string::npos, (std::string(words) + " is not in\n" + text).c_str());
}

TOILE_TEST(tst_Storage)
#include "tst_Storage.moc"
