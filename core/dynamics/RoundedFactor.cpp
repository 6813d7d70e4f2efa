// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/RoundedFactor.h"

#include "core/base/Contracts.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

/// So many subtrees are wanted, whatever the number of threads: then the bits are the same for any.
constexpr int wantedSubtrees = 8;
/// A factor of fewer values is solved with faster than it is shared out.
constexpr std::size_t fewValues = 400'000;

} // namespace

void RoundedFactor::take(const SupernodalFactor& factor) {
    const int count = static_cast<int>(factor.columns.size()) - 1;
    nodes_.clear();
    rows_.assign(factor.rows.begin(), factor.rows.end());
    order_.assign(factor.order.begin(), factor.order.end());
    values_.assign(factor.values.begin(), factor.values.end());
    solution_.assign(order_.size(), 0);
    std::vector<int> nodeOf(order_.size()), parents(count, -1);
    for (int s = 0; s < count; ++s) {
        nodes_.push_back({factor.columns[s], factor.columns[s + 1] - factor.columns[s],
                          factor.rowStart[s + 1] - factor.rowStart[s], factor.rowStart[s], factor.valueStart[s]});
        std::fill(nodeOf.begin() + factor.columns[s], nodeOf.begin() + factor.columns[s + 1], s);
    }
    for (int s = 0; s < count; ++s)
        if (nodes_[s].rows > nodes_[s].columns) parents[s] = nodeOf[rows_[nodes_[s].rowStart + nodes_[s].columns]];
    shareOut(parents);
}

/// Takes apart the heaviest subtrees until there are enough: what is above them is done by one after the other.
void RoundedFactor::shareOut(std::span<const int> parents) {
    const int count = static_cast<int>(nodes_.size());
    std::vector<int> first(count);
    std::vector<std::int64_t> weight(count);
    std::vector<std::vector<int>> children(count);
    std::vector<int> open;
    for (int s = 0; s < count; ++s) {
        first[s] = s;
        weight[s] = std::int64_t{nodes_[s].rows} * nodes_[s].columns;
        for (const int child : children[s]) {
            first[s] = std::min(first[s], first[child]);
            weight[s] += weight[child];
        }
        if (parents[s] < 0) open.push_back(s);
        else children[parents[s]].push_back(s);
    }
    top_.clear();
    while (values_.size() >= fewValues && !open.empty() && std::ssize(open) < wantedSubtrees) {
        const auto heaviest = std::ranges::max_element(open, {}, [&](int s) { return weight[s]; });
        const int taken = *heaviest;
        if (children[taken].empty()) break;
        open.erase(heaviest);
        top_.push_back(taken);
        open.insert(open.end(), children[taken].begin(), children[taken].end());
    }
    std::ranges::sort(open);
    std::ranges::sort(top_);
    subtrees_.clear();
    for (const int s : open) subtrees_.push_back({first[s], s + 1});

    placeAbove_.assign(order_.size(), -1);
    rowsAbove_ = 0;
    for (const int s : top_)
        for (int column = 0; column < nodes_[s].columns; ++column) placeAbove_[nodes_[s].first + column] = rowsAbove_++;
    toAdd_.assign(subtrees_.size(), std::vector<double>(rowsAbove_));
}

/// Rows that lie above are not subtracted from but gathered, where `above` says so.
void RoundedFactor::forward(const Supernode& node, double* x, double* above) const {
    thread_local std::vector<double> local;
    const int* const rows = rows_.data() + node.rowStart;
    local.assign(node.rows, 0);
    std::copy_n(x + node.first, node.columns, local.begin());
    kernels_.forward({values_.data() + node.valueStart, node.rows, node.columns}, local.data());
    std::copy_n(local.begin(), node.columns, x + node.first);
    for (int i = node.columns; i < node.rows; ++i) {
        const int place = above ? placeAbove_[rows[i]] : -1;
        (place >= 0 ? above[place] : x[rows[i]]) += local[i];
    }
}

void RoundedFactor::backward(const Supernode& node, double* x) const {
    thread_local std::vector<double> local;
    const int* const rows = rows_.data() + node.rowStart;
    local.resize(node.rows);
    for (int i = 0; i < node.rows; ++i) local[i] = x[rows[i]];
    kernels_.backward({values_.data() + node.valueStart, node.rows, node.columns}, local.data());
    std::copy_n(local.begin(), node.columns, x + node.first);
}

std::vector<Vec3> RoundedFactor::solve(std::span<const Vec3> b, Team* team) {
    expects(3 * b.size() == order_.size(), "one block of three rows for each vector");
    double* const x = solution_.data();
    for (std::size_t i = 0; i < order_.size(); ++i) x[i] = b[order_[i] / 3][order_[i] % 3];
    const auto inEach = [&](const auto& work) {
        const int count = static_cast<int>(subtrees_.size());
        if (team && count > 1) return team->run(count, work);
        for (int i = 0; i < count; ++i) work(i);
    };
    inEach([&](int i) {
        std::ranges::fill(toAdd_[i], 0.0);
        for (int s = subtrees_[i].first; s < subtrees_[i].last; ++s) forward(nodes_[s], x, toAdd_[i].data());
    });
    for (const int s : top_)
        for (int column = nodes_[s].first; column < nodes_[s].first + nodes_[s].columns; ++column)
            for (const auto& some : toAdd_) x[column] += some[placeAbove_[column]];
    for (const int s : top_) forward(nodes_[s], x, nullptr);
    for (auto s = top_.rbegin(); s != top_.rend(); ++s) backward(nodes_[*s], x);
    inEach([&](int i) {
        for (int s = subtrees_[i].last - 1; s >= subtrees_[i].first; --s) backward(nodes_[s], x);
    });
    std::vector<Vec3> result(b.size());
    for (std::size_t i = 0; i < order_.size(); ++i) result[order_[i] / 3][order_[i] % 3] = x[i];
    return result;
}

std::size_t RoundedFactor::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    std::size_t sum = of(nodes_) + of(rows_) + of(order_) + of(values_) + of(placeAbove_) + of(solution_);
    for (const auto& some : toAdd_) sum += of(some);
    return sum;
}

} // namespace toile::dynamics
