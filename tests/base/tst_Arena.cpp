// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Arena.h"
#include "tests/Suite.h"

#include <QTest>

#include <cstdint>
#include <cstring>
#include <set>

using namespace toile;

class tst_Arena : public QObject {
    Q_OBJECT
private slots:
    void whatLivesInItDoesNotOverlap();
    void placesAreAligned();
    void theSameAgainIsHandedOutAtTheSamePlaces();
    void whatWasHandedOutLastIsTakenBack();
    void vectorsOfVectorsLiveInIt();
};

void tst_Arena::whatLivesInItDoesNotOverlap() {
    Arena arena;
    std::vector<std::pair<unsigned char*, std::size_t>> places;
    for (std::size_t i = 0; i < 300; ++i) {
        const std::size_t size = 1 + (i * i * 37) % 5000;
        auto* place = static_cast<unsigned char*>(arena.allocate(size, 1));
        std::memset(place, static_cast<int>(i % 251), size);
        places.emplace_back(place, size);
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < places[i].second; ++k) QCOMPARE(places[i].first[k], i % 251);
}

void tst_Arena::placesAreAligned() {
    Arena arena;
    for (std::size_t i = 0; i < 2000; ++i) {
        const std::size_t alignment = std::size_t{1} << (i % 7);
        QCOMPARE(reinterpret_cast<std::uintptr_t>(arena.allocate(1 + i % 100, alignment)) % alignment, 0U);
    }
}

void tst_Arena::theSameAgainIsHandedOutAtTheSamePlaces() {
    Arena arena;
    const auto places = [&] {
        arena.rewind();
        std::vector<void*> all;
        for (std::size_t i = 0; i < 200; ++i) all.push_back(arena.allocate(1 + i * 97 % 3001));
        return all;
    };
    places();
    const std::vector<void*> second = places();
    QVERIFY(places() == second);
    QCOMPARE(std::set<void*>(second.begin(), second.end()).size(), second.size());
}

void tst_Arena::whatWasHandedOutLastIsTakenBack() {
    Arena arena;
    void* const kept = arena.allocate(100);
    void* const given = arena.allocate(200);
    arena.deallocate(given, 200);
    QCOMPARE(arena.allocate(200), given);
    arena.deallocate(kept, 100); // waits
    QVERIFY(arena.allocate(50) > given);
}

void tst_Arena::vectorsOfVectorsLiveInIt() {
    Arena arena;
    std::pmr::vector<std::pmr::vector<int>> rows(&arena);
    for (int i = 0; i < 10; ++i) rows.emplace_back(3, i);
    for (const auto& row : rows)
        QCOMPARE(row.get_allocator().resource(), static_cast<std::pmr::memory_resource*>(&arena));
    QCOMPARE(rows[7][2], 7);
}

TOILE_TEST(tst_Arena)
#include "tst_Arena.moc"
