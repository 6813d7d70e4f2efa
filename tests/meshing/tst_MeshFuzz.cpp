// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/meshing/MeshInputJson.h"
#include "tests/meshing/MeshReferee.h"
#include "tests/meshing/RandomMeshInput.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

using namespace toile;
using namespace toile::meshing;

/// Random garments with curves, holes, slits, regions, folds and seams: each is refused with a sentence and a place,
/// or gives meshes without a defect. TOILE_FUZZ=1000000 runs so many, TOILE_FUZZ_FROM=7 begins at that seed;
/// an input that fails is written beside the program and belongs into tests/meshing/corpus once it is mended.
class tst_MeshFuzz : public QObject {
    Q_OBJECT
public:
    static void initMain() {
        if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) // 5 minutes are too short for more seeds
            qputenv("QTEST_FUNCTION_TIMEOUT", "86400000");
    }
private slots:
    void initTestCase();
    void randomGarmentsMeshOrAreRefused();
    void whatOnceFailedIsMeshedOrRefused_data();
    void whatOnceFailedIsMeshedOrRefused();
    void inputsComeBackFromTheirText();
};

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

volatile std::sig_atomic_t runningSeed = 0;

extern "C" void nameTheSeed(int signal) {
    char text[64] = "died at seed ";
    char digits[24];
    int n = 0;
    for (long seed = runningSeed; seed > 0 || n == 0; seed /= 10) digits[n++] = static_cast<char>('0' + seed % 10);
    std::size_t length = 13;
    while (n > 0) text[length++] = digits[--n];
    text[length++] = '\n';
    [[maybe_unused]] const auto written = write(2, text, length);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// The chords of a border whose nodes lie on it: the area differs by no more than the deviation times the
/// length.
bool areaIsRight(const PieceReport& report, const PieceMesh& mesh) {
    double perimeter = 0;
    for (const auto& loop : mesh.loops)
        for (const EdgeNodes& edge : loop)
            for (std::size_t k = 0; k + 1 < edge.size(); ++k)
                perimeter += distance(mesh.nodes[static_cast<std::size_t>(edge[k].node)],
                                      mesh.nodes[static_cast<std::size_t>(edge[k + 1].node)]);
    const double exact = displayArea(mesh), allowed = report.boundaryDeviation * perimeter * 1.2 + 1e-7 * perimeter;
    return report.areaRelativeError * exact <= allowed * 1.5;
}

/// Sewn nodes lie at equal parts of every stretch between fixed points; empty when they do.
std::string seamDefect(const GarmentMesh& garment, std::size_t seam) {
    const SeamReport& report = garment.report.seams[seam];
    if (report.countA != report.countB) return "unequal counts of sewing points";
    std::size_t joints = 0; // where a chain passes to another piece or edge both corners are listed
    const auto& pairs = garment.seams[seam].pairs;
    for (std::size_t k = 0; k + 1 < pairs.size(); ++k)
        joints += pairs[k][0] == pairs[k + 1][0] || pairs[k][1] == pairs[k + 1][1];
    const auto points = static_cast<std::size_t>(report.countA);
    if (pairs.size() < points - std::min<std::size_t>(points, joints) || pairs.size() > points + joints)
        return std::to_string(pairs.size()) + " pairs for " + std::to_string(report.countA) + " points";
    for (const auto& [a, b] : pairs)
        for (const NodeRef node : {a, b})
            if (node.node < 0 ||
                node.node >= static_cast<int>(garment.pieces[static_cast<std::size_t>(node.piece)].nodes.size()))
                return "a pair without a node";
    return {};
}

/// Empty when the property holds.
std::string failureOf(const MeshInput& input, bool& isMeshed) {
    const auto garment = meshGarment(input);
    isMeshed = garment.has_value();
    if (!garment) {
        if (garment.error().text.empty()) return "an error without a sentence";
        if (garment.error().place.object.empty()) return "an error without a place: " + garment.error().text;
        return {};
    }
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        const std::string piece = "piece " + std::to_string(p) + ": ";
        if (const auto defect = defectOf(garment->pieces[p], static_cast<int>(input.pieces[p].holes.size()));
            !defect.empty())
            return piece + defect;
        const PieceReport& report = garment->report.pieces[p];
        if (report.invertedCells + report.missingBoundaryNodes + report.nonManifoldEdges != 0)
            return piece + "the report counts defects that the test does not";
        if (!areaIsRight(report, garment->pieces[p]))
            return piece + "area error " + std::to_string(report.areaRelativeError);
        for (const FoldReport& fold : report.folds)
            if (const auto defect = foldDefectOf(garment->pieces[p], fold, input.pieces[p].spacing); !defect.empty())
                return piece + defect;
    }
    for (std::size_t s = 0; s < input.seams.size(); ++s)
        if (const auto defect = seamDefect(*garment, s); !defect.empty())
            return "seam " + std::to_string(s) + ": " + defect;
    return {};
}

QString corpusFolder() {
    return qEnvironmentVariable("TOILE_SOURCE_DIR", ".") + "/tests/meshing/corpus";
}

} // namespace

void tst_MeshFuzz::initTestCase() {
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE}) std::signal(signal, nameTheSeed);
    if (isSanitized) return; // the shadow is terabytes of addresses
    rlimit memory{};
    QCOMPARE(getrlimit(RLIMIT_AS, &memory), 0);
    memory.rlim_cur = std::min(memory.rlim_max, rlim_t{4} << 30); // an input that takes all ends us, not the machine
    QCOMPARE(setrlimit(RLIMIT_AS, &memory), 0);
}

void tst_MeshFuzz::randomGarmentsMeshOrAreRefused() {
    const long first = std::max(1, qEnvironmentVariableIntValue("TOILE_FUZZ_FROM"));
    const long count = qEnvironmentVariableIsSet("TOILE_FUZZ") ? qEnvironmentVariableIntValue("TOILE_FUZZ")
                       : isSanitized                           ? 5000
                                                               : 30000;
    int meshed = 0, failed = 0;
    for (long seed = first; seed < first + count; ++seed) {
        runningSeed = seed;
        const MeshInput input = RandomMeshInput(static_cast<std::uint64_t>(seed))();
        bool isMeshed = false;
        const std::string failure = failureOf(input, isMeshed);
        meshed += isMeshed;
        if (failure.empty()) continue;
        ++failed;
        const QString file = QString("mesh-fuzz-%1.json").arg(seed);
        if (QFile out(file); out.open(QIODevice::WriteOnly)) out.write(toText(jsonOf(input)).c_str());
        qWarning("seed %ld: %s (written to %s)", seed, failure.c_str(), qPrintable(file));
    }
    qInfo("%ld inputs, %d meshed, the others refused", count, meshed);
    QCOMPARE(failed, 0);
    QVERIFY(meshed > count / 4); // a generator of nonsense alone would test little
}

void tst_MeshFuzz::whatOnceFailedIsMeshedOrRefused_data() {
    QTest::addColumn<QString>("file");
    for (const QString& name : QDir(corpusFolder()).entryList({"*.json"}, QDir::Files))
        QTest::addRow("%s", qPrintable(name)) << corpusFolder() + "/" + name;
}

void tst_MeshFuzz::whatOnceFailedIsMeshedOrRefused() {
    QFETCH(QString, file);
    QFile in(file);
    QVERIFY(in.open(QIODevice::ReadOnly));
    const auto json = parseJson(in.readAll().toStdString(), file.toStdString());
    QVERIFY2(json, json ? "" : toString(json.error()).c_str());
    bool isMeshed = false;
    QCOMPARE(QString::fromStdString(failureOf(InputReader::input(*json), isMeshed)), QString());
}

void tst_MeshFuzz::inputsComeBackFromTheirText() {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const std::string text = toText(jsonOf(RandomMeshInput(seed)()));
        QCOMPARE(toText(jsonOf(InputReader::input(*parseJson(text)))), text);
    }
}

TOILE_TEST(tst_MeshFuzz)
#include "tst_MeshFuzz.moc"
