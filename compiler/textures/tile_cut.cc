// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_cut.h"

#include <array>
#include <bit>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <utility>

namespace texgraph::textures {
namespace {

// Borders that cost nothing else are short, too.
constexpr int64_t kBorder = 1;
constexpr uint32_t kMaxLabels = 8;
constexpr uint32_t kMaxMoves = 32;

using Graph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, uint32_t, uint32_t>;

// A network with a source (vertex 0), a sink (vertex 1) and nodes from 2 on.
class Network {
 public:
  explicit Network(uint32_t nodes) : to_source_(nodes), to_sink_(nodes) {}

  // What it costs that the node is on the sink's side; negative: on the source's side.
  void AddNode(uint32_t node, int64_t cost) {
    (cost > 0 ? to_source_ : to_sink_)[node] += std::abs(cost);
  }
  // What it costs that `from` is on the source's side and `to` on the sink's.
  void AddPair(uint32_t from, uint32_t to, int64_t cost) {
    if (cost > 0) pairs_.push_back({from, to, cost});
  }
  // True for the nodes that have to be on the sink's side.
  std::vector<bool> Cut();

 private:
  struct Pair {
    uint32_t from;
    uint32_t to;
    int64_t cost;
  };
  struct Arcs {
    std::vector<std::pair<uint32_t, uint32_t>> ends;
    std::vector<int64_t> costs;
    std::vector<uint32_t> reverse;
  };
  Arcs SortedArcs() const;

  std::vector<int64_t> to_source_;
  std::vector<int64_t> to_sink_;
  std::vector<Pair> pairs_;
};

// In the order of their first ends, as the graph wants them, with both directions of each.
Network::Arcs Network::SortedArcs() const {
  std::vector<Pair> both;
  both.reserve(2 * (pairs_.size() + to_source_.size()));
  const auto add = [&](uint32_t from, uint32_t to, int64_t cost) {
    both.push_back({from, to, cost});
    both.push_back({to, from, 0});
  };
  for (uint32_t i = 0; i < to_source_.size(); ++i) {
    const int64_t less = std::min(to_source_[i], to_sink_[i]);
    if (to_source_[i] > less) add(0, i + 2, to_source_[i] - less);
    if (to_sink_[i] > less) add(i + 2, 1, to_sink_[i] - less);
  }
  for (const Pair& pair : pairs_) add(pair.from + 2, pair.to + 2, pair.cost);
  std::vector<uint32_t> first(to_source_.size() + 3);
  for (const Pair& arc : both) ++first[arc.from + 1];
  for (size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<uint32_t> place(both.size());
  Arcs arcs;
  arcs.ends.resize(both.size());
  arcs.costs.resize(both.size());
  arcs.reverse.resize(both.size());
  for (size_t i = 0; i < both.size(); ++i) {
    place[i] = first[both[i].from]++;
    arcs.ends[place[i]] = {both[i].from, both[i].to};
    arcs.costs[place[i]] = both[i].cost;
  }
  for (size_t i = 0; i < both.size(); ++i) arcs.reverse[place[i]] = place[i ^ 1];
  return arcs;
}

std::vector<bool> Network::Cut() {
  Arcs arcs = SortedArcs();
  const auto vertices = static_cast<uint32_t>(to_source_.size() + 2);
  const Graph graph(boost::edges_are_sorted, arcs.ends.begin(), arcs.ends.end(), vertices);
  using Edge = boost::graph_traits<Graph>::edge_descriptor;
  std::vector<Edge> edges(arcs.ends.size());
  const auto index = get(boost::edge_index, graph);
  for (auto [at, end] = boost::edges(graph); at != end; ++at) edges[get(index, *at)] = *at;
  std::vector<Edge> reverse(edges.size());
  for (size_t i = 0; i < edges.size(); ++i) reverse[i] = edges[arcs.reverse[i]];
  std::vector<int64_t> residual(edges.size());
  std::vector<Edge> parents(vertices);
  std::vector<boost::default_color_type> colors(vertices);
  std::vector<int64_t> distances(vertices);
  const auto by_edge = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), index);
  };
  const auto by_vertex = [&](auto& values) {
    return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
  };
  boost::boykov_kolmogorov_max_flow(graph, by_edge(arcs.costs), by_edge(residual), by_edge(reverse),
                                    by_vertex(parents), by_vertex(colors), by_vertex(distances),
                                    get(boost::vertex_index, graph), 0u, 1u);
  std::vector<bool> at_sink(to_source_.size());
  for (size_t i = 0; i < at_sink.size(); ++i)
    at_sink[i] = colors[i + 2] == boost::color_traits<boost::default_color_type>::white();
  return at_sink;
}

constexpr uint32_t kNone = ~0u;

// One move: every texel keeps its label or takes `alpha`.
class Expansion {
 public:
  Expansion(TileCut& cut, uint32_t alpha)
      : cut_(cut), alpha_(alpha), node_(cut.labels.size(), kNone) {
    for (uint32_t i = 0; i < node_.size(); ++i) {
      if (cut.labels[i] == alpha || !(cut.allowed[i] >> alpha & 1)) continue;
      node_[i] = static_cast<uint32_t>(texels_.size());
      texels_.push_back(i);
    }
  }

  // True if a label changed.
  bool Move() {
    if (texels_.empty()) return false;
    Network network(static_cast<uint32_t>(texels_.size()));
    for (uint32_t texel : texels_) AddBorders(texel, network);
    const std::vector<bool> moved = network.Cut();
    bool any = false;
    for (size_t i = 0; i < texels_.size(); ++i) {
      if (!moved[i]) continue;
      cut_.labels[texels_[i]] = static_cast<uint8_t>(alpha_);
      any = true;
    }
    return any;
  }

 private:
  int64_t Border(uint32_t p, uint32_t q, uint32_t a, uint32_t b) const {
    if (a == b) return 0;
    const uint32_t side = cut_.side;
    return int64_t{cut_.cost(p % side, p / side, a, b)} + cut_.cost(q % side, q / side, a, b) +
           kBorder;
  }

  void AddBorders(uint32_t p, Network& network) {
    const uint32_t side = cut_.side;
    const uint32_t x = p % side;
    const uint32_t y = p / side;
    if (x > 0) AddBorder(p, p - 1, network);
    if (y > 0) AddBorder(p, p - side, network);
    // Towards higher texels only those that do not come here themselves.
    if (x + 1 < side && node_[p + 1] == kNone) AddBorder(p, p + 1, network);
    if (y + 1 < side && node_[p + side] == kNone) AddBorder(p, p + side, network);
  }

  // Kolmogorov and Zabih 2004, with 1 for a texel that takes alpha: it goes to the sink's side.
  void AddBorder(uint32_t p, uint32_t q, Network& network) {
    const uint32_t fp = cut_.labels[p];
    const uint32_t fq = cut_.labels[q];
    const int64_t both_stay = Border(p, q, fp, fq);
    const int64_t p_moves = Border(p, q, alpha_, fq);
    if (node_[q] == kNone) return network.AddNode(node_[p], p_moves - both_stay);
    const int64_t q_moves = Border(p, q, fp, alpha_);
    network.AddNode(node_[p], p_moves - both_stay);
    network.AddNode(node_[q], -p_moves);
    network.AddPair(node_[p], node_[q], p_moves + q_moves - both_stay);
  }

  TileCut& cut_;
  uint32_t alpha_;
  std::vector<uint32_t> node_;
  std::vector<uint32_t> texels_;
};

}  // namespace

int64_t TileCut::Energy() const {
  int64_t energy = 0;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = labels[y * side + x];
      const auto add = [&](uint32_t to_x, uint32_t to_y) {
        if (to_x >= side || to_y >= side) return;
        const uint32_t b = labels[to_y * side + to_x];
        if (a != b) energy += int64_t{cost(x, y, a, b)} + cost(to_x, to_y, a, b) + kBorder;
      };
      add(x + 1, y);
      add(x, y + 1);
    }
  }
  return energy;
}

void TileCut::Improve() {
  uint32_t all = 0;
  for (uint8_t set : allowed) all |= std::has_single_bit(set) ? 0u : set;
  // Moves since the last that changed something: after one of each label there is no more to gain.
  int idle = 0;
  uint32_t alpha = 0;
  for (uint32_t move = 0; move < kMaxMoves && idle < std::popcount(all); ++move, ++alpha) {
    while (!(all >> alpha % kMaxLabels & 1)) ++alpha;
    idle = Expansion(*this, alpha % kMaxLabels).Move() ? 0 : idle + 1;
  }
}

}  // namespace texgraph::textures
