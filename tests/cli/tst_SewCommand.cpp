// SPDX-License-Identifier: GPL-3.0-or-later
#include "SewFolder.h"
#include "tests/Suite.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

using namespace toile;

class tst_SewCommand : public QObject, private SewFolder {
    Q_OBJECT
private slots:
    void init() { QVERIFY(makeAnew()); }
    void twoSquaresAreSewn();
    void theReportHasTheKeysThatArePromised();
    void whatIsNotThereIsNull();
    void theAvatarMovesOnceTheClothHangs();
    void motionsThatCannotBeAreRefused();
    void equalRunsGiveEqualBits();
    void aFinerMeshGetsMoreSubsteps();
    void aFineGarmentIsSewnOnItsOwnMeshFirst();
    void aCoarserMeshIsNoRefinement();
    void selfContactCanBeAskedForWhereTheDocumentDoesNot();
    void quietSaysNothing();
    void aSeamHeldOpenIsAGoalMissed();
    void aLimitThatIsTooShortIsAGoalMissed();
    void aTimeLimitEndsARunWhereverItIs_data();
    void aTimeLimitEndsARunWhereverItIs();
    void aStartInTheBodyIsWarnedOfRefusedOrArranged();
    void piecesThatArePlacedThroughEachOtherAreNamed();
    void everyMethodDrapesWhatXpbdHasSewn_data();
    void everyMethodDrapesWhatXpbdHasSewn();
    void thePaperGoesItsOwnWayFromEndToEnd();
    void staticsKnowsNoTime();
    void theReportSaysHowManyThreadsThereWere();
    void wrongUsage_data();
    void wrongUsage();
};

void tst_SewCommand::twoSquaresAreSewn() {
    const Finished finished =
        run({"sew", sample("two-squares.toile"), "--out", in("drape.glb"), "--report", in("sew.json")});
    QVERIFY2(finished.status == 0, qPrintable(finished.err));
    QVERIFY(finished.out.contains("1 of 1 seams closed"));
    QVERIFY(contentOf(in("drape.glb")).startsWith("glTF"));
    const Json json = report();
    const Json& seam = json.find("seams")->asArray()->front();
    QCOMPARE(*seam.find("closed")->asBool(), true);
    QCOMPARE(*seam.find("maximumGap")->asNumber(), 0.0);
    QVERIFY(*seam.find("gapAtMergeMaximum")->asNumber() <= 0.5e-3);
    QCOMPARE(QDir(folder_->path()).entryList(QDir::Files).size(), 2);
}

void tst_SewCommand::theReportHasTheKeysThatArePromised() {
    QVERIFY(
        run({"sew", sample("tube.toile"), "--spacing", "40", "--seconds", "1", "--report", in("sew.json")}).status >=
        0);
    const Json json = report();
    QCOMPARE(missingKeys(json, {"document",      "avatar",    "method",           "step",
                                "threads",       "particles", "springs",          "seams",
                                "worn",          "contact",   "clampedCells",     "finishDisplacementMaximum",
                                "finishSeconds", "strain",    "simulatedSeconds", "cpuSeconds",
                                "wallSeconds",   "steps",     "atRest",           "residual",
                                "energy",        "peakBytes", "resultHash",       "stages",
                                "leftOut",       "warnings"}),
             QString());
    QCOMPARE(missingKeys(*json.find("springs"), {"structural", "shear", "bending", "twist"}), QString());
    for (const Json& seam : *json.find("seams")->asArray())
        QCOMPARE(missingKeys(seam, {"name", "pairs", "initialGap", "gapAtMergeMaximum", "maximumGap", "meanGap",
                                    "merged", "closed"}),
                 QString());
    QCOMPARE(missingKeys(*json.find("worn"), {"verdict", "openings", "rightSideOut", "landmarks"}), QString());
    QCOMPARE(missingKeys(*json.find("contact"), {"bodyPenetrationMaximum", "bodyClearanceMinimum", "selfIntersections",
                                                 "bodyIntersections", "guarantee"}),
             QString());
    QCOMPARE(missingKeys(*json.find("strain"), {"warpMaximum", "weftMaximum", "shearMaximum", "rms"}), QString());
    QCOMPARE(missingKeys(*json.find("curvature"), {"rms", "alternating"}), QString());
    QCOMPARE(missingKeys(*json.find("energy"), {"kinetic", "gravity", "elastic"}), QString());
    for (const Json& stage : *json.find("stages")->asArray())
        QCOMPARE(missingKeys(stage, {"name", "seconds", "share"}), QString());
    for (const Json& left : *json.find("leftOut")->asArray()) QCOMPARE(missingKeys(left, {"stage", "why"}), QString());
    QVERIFY(*json.find("peakBytes")->asNumber() > 1e6); // a program holds more than a megabyte
    QCOMPARE(json.find("resultHash")->asString()->size(), std::size_t(64));
    QCOMPARE(*json.find("method")->asString(), std::string("xpbd"));
}

void tst_SewCommand::whatIsNotThereIsNull() {
    QCOMPARE(run({"sew", sample("two-squares.toile"), "--seconds", "3", "--report", in("sew.json")}).status, 0);
    const Json json = report();
    QVERIFY(json.find("avatar")->isNull());
    QVERIFY(json.find("worn")->find("verdict")->isNull());
    QVERIFY(!json.find("worn")->find("why")->asArray()->empty()); // null with a reason
    QVERIFY(json.find("contact")->find("bodyClearanceMinimum")->isNull());
    QVERIFY(json.find("residual")->isNull()); // a run of so many seconds has no finish
    QVERIFY(json.find("finishDisplacementMaximum")->isNull());
    QVERIFY(json.find("finishSeconds")->isNull());
    QVERIFY(json.find("coarse")->find("particles")->isNull());
    QVERIFY(!contentOf(in("sew.json")).contains("nan"));
}

void tst_SewCommand::theAvatarMovesOnceTheClothHangs() {
    const QStringList sheet{
        "sew",         sample("sheet-two-corners.toile"), "--spacing", "100", "--limit", "0.1", "--quiet", "--report",
        in("sew.json")};
    body::Body body = box(0.2, 0.2);
    QVERIFY(QDir().mkpath(in("poses")));
    QVERIFY(io::writeBody(in("box.glb").toStdString(), body).has_value());
    QVERIFY(io::writeBody(in("poses/a.glb").toStdString(), body).has_value());
    for (Vec3& v : body.mesh.vertices) v.y += 0.1;
    QVERIFY(io::writeBody(in("poses/b.glb").toStdString(), body).has_value());
    const Finished pushed =
        run(sheet + QStringList{"--avatar", in("box.glb"), "--motion", in("poses"), "--motion-step", "0.1"});
    QVERIFY2(pushed.out.contains("the body moved for 0.10 s, at 1.0 m/s at most"), qPrintable(pushed.out));
    QJsonObject motion = QJsonDocument::fromJson(contentOf(in("sew.json"))).object()["motion"].toObject();
    QCOMPARE(motion["steps"].toInt(), 6);

    const Finished lifted = run(
        sheet + QStringList{"--avatar", sample("bodies/mannequin-42.glb"), "--lift-arms", "20", "--lift-time", "0.2"});
    QVERIFY2(lifted.out.contains("the body moved for 0.20 s"), qPrintable(lifted.out + lifted.err));
    motion = QJsonDocument::fromJson(contentOf(in("sew.json"))).object()["motion"].toObject();
    QCOMPARE(motion["steps"].toInt(), 12);
    QVERIFY(motion["bodySpeedMaximum"].toDouble() > 0.5);
}

void tst_SewCommand::motionsThatCannotBeAreRefused() {
    const QStringList sheet{"sew", sample("sheet-two-corners.toile"), "--spacing", "100", "--limit", "0.1"};
    const Finished bare = run(sheet + QStringList{"--lift-arms", "20"});
    QCOMPARE(bare.status, 1);
    QVERIFY2(bare.err.contains("no avatar that could move"), qPrintable(bare.err));
    const Finished both = run(sheet + QStringList{"--lift-arms", "20", "--motion", in("poses")});
    QCOMPARE(both.status, 2);
    const Finished kept = run(sheet + QStringList{"--avatar", sample("bodies/mannequin-42.glb"), "--lift-arms", "20",
                                                  "--checkpoint", in("point")});
    QCOMPARE(kept.status, 2);
    const Finished fine = run({"sew", sample("t-shirt.toile"), "--spacing", "20", "--refine", "--motion", in("none")});
    QCOMPARE(fine.status, 1);
    QVERIFY2(fine.err.contains("none") && !fine.err.contains("simulated"), qPrintable(fine.err)); // before it is sewn
}

void tst_SewCommand::equalRunsGiveEqualBits() {
    QStringList hashes;
    for (const QStringList& more : {QStringList{}, QStringList{}, QStringList{"--threads", "4", "--deterministic"}}) {
        QVERIFY(run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + more).status == 0);
        hashes << QString::fromStdString(*report().find("resultHash")->asString());
    }
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
}

/// A document that asks for 30 substeps on its own mesh of 100 mm.
void tst_SewCommand::aFinerMeshGetsMoreSubsteps() {
    document::Document sheet = samples::squareSheet(samples::SheetPins::oneEdge);
    pattern::Piece piece = *sheet.pattern.pieces[0];
    piece.spacing = 0.1;
    sheet.pattern.pieces[0] = piece;
    sheet.scene.substeps = 30;
    QVERIFY(io::writeToile(sheet, in("sheet.toile").toStdString()).has_value());
    const auto substeps = [&](const QStringList& options) {
        run(QStringList{"sew", in("sheet.toile"), "--seconds", "0.05", "--report", in("sew.json")} + options);
        return *report().find("substeps")->asNumber();
    };
    QCOMPARE(substeps({}), 30.0);
    QCOMPARE(substeps({"--spacing", "40"}), 75.0);
    QCOMPARE(substeps({"--spacing", "200"}), 30.0); // coarser: not fewer
    QCOMPARE(substeps({"--spacing", "40", "--substeps", "20"}), 20.0);
    QVERIFY(substeps({"--substeps", "auto"}) < 30);
}

void tst_SewCommand::aFineGarmentIsSewnOnItsOwnMeshFirst() {
    const auto particles = [&](const QStringList& options) {
        const Finished finished =
            run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + options);
        return finished.status == 0 ? *report().find("particles")->asNumber() : -1;
    };
    const double own = particles({}), fine = particles({"--spacing", "10"});
    QVERIFY(own > 0 && fine > own);
    QCOMPARE(particles({"--spacing", "10", "--refine"}), fine);
    const Json json = report();
    const Json& coarse = *json.find("coarse");
    QCOMPARE(*coarse.find("particles")->asNumber(), own);
    QCOMPARE(*coarse.find("ending")->asString(), std::string("at rest"));
    QVERIFY(*coarse.find("simulatedSeconds")->asNumber() < *json.find("simulatedSeconds")->asNumber());
    QVERIFY(*coarse.find("cpuSeconds")->asNumber() < *json.find("cpuSeconds")->asNumber());
    QVERIFY(*json.find("atRest")->asBool());
}

void tst_SewCommand::aCoarserMeshIsNoRefinement() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--spacing", "100", "--refine"});
    QCOMPARE(finished.status, 1);
    QVERIFY2(finished.err.contains("no coarser than --spacing 100"), qPrintable(finished.err));
    QVERIFY(finished.err.contains("two-squares.toile"));
}

void tst_SewCommand::selfContactCanBeAskedForWhereTheDocumentDoesNot() {
    const auto hasStage = [&](const QStringList& options) {
        const Finished finished =
            run(QStringList{"sew", sample("two-squares.toile"), "--report", in("sew.json")} + options);
        if (finished.status != 0) qFatal("%s", qPrintable(finished.err));
        const Json json = report();
        return std::ranges::any_of(*json.find("stages")->asArray(),
                                   [](const Json& stage) { return *stage.find("name")->asString() == "self-contact"; });
    };
    QVERIFY(!hasStage({}));
    QVERIFY(hasStage({"--self-contact"}));
}

void tst_SewCommand::quietSaysNothing() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--quiet"});
    QCOMPARE(finished.status, 0);
    QVERIFY2(finished.err.isEmpty(), qPrintable(finished.err));
}

void tst_SewCommand::aSeamHeldOpenIsAGoalMissed() {
    const QString document = squaresWith(box(0.05, 2.0));
    const Finished finished =
        run({"sew", document, "--limit", "6", "--out", in("drape.glb"), "--report", in("sew.json"), "--quiet"});
    QCOMPARE(finished.status, 3);
    QVERIFY(finished.out.contains("0 of 1 seams closed"));
    QVERIFY(finished.err.contains("seam \"middle\": The seam is not closed; its gap is 5"));
    const Json json = report();
    const Json& seam = json.find("seams")->asArray()->front();
    QCOMPARE(*seam.find("closed")->asBool(), false);
    QVERIFY(*seam.find("maximumGap")->asNumber() >= 0.050);
    QVERIFY(!contentOf(in("drape.glb")).isEmpty()); // what there is can still be looked at
}

void tst_SewCommand::aLimitThatIsTooShortIsAGoalMissed() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--limit", "1.5", "--report", in("sew.json")});
    QCOMPARE(finished.status, 3);
    QCOMPARE(*report().find("ending")->asString(), std::string("limit reached"));
    QCOMPARE(*report().find("atRest")->asBool(), false);
}

void tst_SewCommand::aTimeLimitEndsARunWhereverItIs_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("until rest") << QStringList{};
    QTest::newRow("for so long") << QStringList{"--seconds", "600"};
    QTest::newRow("refined") << QStringList{"--refine", "--spacing", "5"};
    QTest::newRow("adaptive parts") << QStringList{"--method", "trbdf2"};
}

void tst_SewCommand::aTimeLimitEndsARunWhereverItIs() {
    QFETCH(QStringList, options);
    const Finished finished = run(QStringList{"sew", sample("two-squares.toile"), "--time-limit", "0.001", "--report",
                                              in("sew.json"), "--checkpoint", in("point")} +
                                  options);
    QCOMPARE(finished.status, 3);
    QVERIFY2(finished.out.contains("time limit reached"), qPrintable(finished.out));
    QVERIFY2(finished.err.contains("time limit: It was reached before"), qPrintable(finished.err));
    QCOMPARE(*report().find("ending")->asString(), std::string("time limit reached"));
    QCOMPARE(*report().find("atRest")->asBool(), false);
    QVERIFY(contentOf(in("point")).contains("toile-checkpoint"));
}

void tst_SewCommand::aStartInTheBodyIsWarnedOfRefusedOrArranged() {
    const QString document = squaresWith(box(1.0, 0.1)); // the squares hang in its middle, in the plane z = 0
    const Finished warned = run({"sew", document, "--seconds", "0.02", "--quiet"});
    QCOMPARE(warned.status, 3);
    QVERIFY2(warned.err.contains("start: The garment starts 50.0 mm inside the body"), qPrintable(warned.err));
    const Finished refused = run({"sew", document, "--seconds", "0.02", "--strict", "--out", in("drape.glb")});
    QCOMPARE(refused.status, 1);
    QVERIFY(refused.err.contains("leave out --strict"));
    QVERIFY(!QFile::exists(in("drape.glb")));
    const Finished arranged = run({"sew", document, "--seconds", "0.02", "--strict", "--arrange", "auto", "--quiet"});
    QCOMPARE(arranged.status, 3); // in so short a time no seam closes
    QVERIFY(!arranged.err.contains("inside the body"));
}

void tst_SewCommand::piecesThatArePlacedThroughEachOtherAreNamed() {
    document::Document document = samples::twoSquares();
    pattern::Piece right = *document.pattern.pieces[1];
    right.placement->transform.origin.x -= 0.23; // over the left one by 30 mm
    document.pattern.pieces[1] = right;
    QVERIFY(io::writeToile(document, in("over.toile").toStdString()));
    const auto names = [&](bool selfContact) {
        const Finished finished = run(QStringList{"sew", in("over.toile"), "--quiet"} +
                                      (selfContact ? QStringList{"--self-contact"} : QStringList{}));
        return finished.status == 0 && finished.err.contains("pieces \"Left square\" and \"Right square\": They are "
                                                             "placed through each other");
    };
    QVERIFY(names(true) && !names(false));
}

void tst_SewCommand::everyMethodDrapesWhatXpbdHasSewn_data() {
    QTest::addColumn<QString>("method");
    for (const char* method : {"xpbd", "trbdf2", "static", "backward-euler", "bdf2", "midpoint", "sdirk4", "rk4",
                               "symplectic-euler", "subcycled-euler", "baraff-witkin"})
        QTest::newRow(method) << method;
}

void tst_SewCommand::everyMethodDrapesWhatXpbdHasSewn() {
    QFETCH(QString, method);
    QStringList arguments{
        "sew",         sample("two-squares.toile"), "--spacing", "50", "--method", method, "--quiet", "--report",
        in("sew.json")};
    if (method != "static")
        arguments << "--seconds"
                  << "0.8";
    const Finished finished = run(arguments);
    QVERIFY2(finished.status == 0 || finished.status == 3, qPrintable(finished.err));
    const Json json = report();
    QCOMPARE(QString::fromStdString(*json.find("method")->asString()), method);
    const auto& phases = *json.find("phases")->asArray();
    QCOMPARE(*phases.front().find("name")->asString(), std::string("sewing"));
    QCOMPARE(*phases.front().find("method")->asString(), std::string("xpbd"));
    if (method == "static") return; // whatever it needs to settle
    QVERIFY(phases.size() >= 2);
    QCOMPARE(QString::fromStdString(*phases.back().find("method")->asString()), method);
    QVERIFY(*phases.back().find("parts")->asNumber() >= 1);
    const bool isExplicit = method == "rk4" || method == "symplectic-euler" || method == "subcycled-euler";
    QCOMPARE(phases.back().find("stepLimit")->asNumber() != nullptr, isExplicit);
    QCOMPARE(finished.out.contains("stable in steps of up to"), isExplicit);
    QVERIFY(finished.out.contains("left out: "));
    for (const Json& left : *json.find("leftOut")->asArray())
        QVERIFY(finished.out.contains(QString::fromStdString(*left.find("stage")->asString())));
}

void tst_SewCommand::thePaperGoesItsOwnWayFromEndToEnd() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--spacing", "50", "--paper", "--seconds", "1",
                                   "--quiet", "--report", in("sew.json")});
    QVERIFY2(finished.status == 0, qPrintable(finished.err + finished.out));
    const Json json = report();
    QCOMPARE(*json.find("method")->asString(), std::string("paper"));
    for (const Json& phase : *json.find("phases")->asArray())
        QCOMPARE(*phase.find("method")->asString(), std::string("subcycled-euler"));
    QVERIFY(*json.find("springs")->find("flexion")->asNumber() > 0);
    QCOMPARE(*json.find("springs")->find("bending")->asNumber(), 0.0);
    const Finished both = run({"sew", sample("two-squares.toile"), "--paper", "--method", "trbdf2"});
    QCOMPARE(both.status, 2);
    QVERIFY(both.err.contains("--method"));
}

void tst_SewCommand::staticsKnowsNoTime() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--method", "static", "--seconds", "1"});
    QCOMPARE(finished.status, 1);
    QVERIFY(finished.err.contains("--seconds"));
}

void tst_SewCommand::theReportSaysHowManyThreadsThereWere() {
    const Finished finished = run({"sew", sample("two-squares.toile"), "--seconds", "0.1", "--threads", "3", "--quiet",
                                   "--report", in("sew.json")});
    QCOMPARE(finished.status, 3); // no garment is sewn in a tenth of a second
    QCOMPARE(*report().find("threads")->asNumber(), 3.0);
}

void tst_SewCommand::wrongUsage_data() {
    QTest::addColumn<QStringList>("options");
    QTest::newRow("an unknown option") << QStringList{"--faster"};
    QTest::newRow("an unknown method") << QStringList{"--method", "magic"};
    QTest::newRow("an unknown arrangement") << QStringList{"--arrange", "tidy"};
    QTest::newRow("so long, and until rest") << QStringList{"--seconds", "3", "--until-rest"};
    QTest::newRow("the paper has no self-contact") << QStringList{"--paper", "--self-contact"};
    QTest::newRow("refined to nothing") << QStringList{"--refine"};
    QTest::newRow("refined in no time") << QStringList{"--refine", "--spacing", "20", "--seconds", "3"};
    QTest::newRow("no substep") << QStringList{"--substeps", "0"};
    QTest::newRow("no thread") << QStringList{"--threads", "0"};
    QTest::newRow("a step of nothing") << QStringList{"--step", "0"};
    for (const char* option : {"--seconds", "--limit", "--time-limit", "--hold", "--spacing", "--step", "--lift-arms"})
        for (const char* value : {"nan", "-nan", "inf"})
            QTest::addRow("%s %s", option, value) << QStringList{option, value};
    for (const char* option : {"--avatar", "--out", "--report", "--frames", "--checkpoint", "--resume", "--picture"})
        QTest::addRow("%s of nothing", option) << QStringList{option, ""};
    QTest::newRow("--lift-time nan") << QStringList{"--lift-arms", "20", "--lift-time", "nan"};
    QTest::newRow("--motion-step nan") << QStringList{"--motion", "poses", "--motion-step", "nan"};
}

void tst_SewCommand::wrongUsage() {
    QFETCH(QStringList, options);
    const Finished finished = run(QStringList{"sew", sample("two-squares.toile")} + options);
    QCOMPARE(finished.status, 2);
    QVERIFY(!finished.err.isEmpty());
    if (options.last() == "nan" || options.last().isEmpty())
        QVERIFY2(finished.err.contains(options[options.size() - 2]), qPrintable(finished.err));
}

TOILE_TEST(tst_SewCommand, QCoreApplication)
#include "tst_SewCommand.moc"
