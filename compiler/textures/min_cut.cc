// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/min_cut.h"

#include <algorithm>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <utility>

namespace texgraph::textures {
namespace {

using Graph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, uint32_t, uint32_t>;

}  // namespace

// In the order of their first ends, as the graph wants them, with both directions of each.
MinCut::Arcs MinCut::SortedArcs() const {
  std::vector<Pair> both;
  both.reserve(2 * (pairs_.size() + to_source_.size()));
  const auto add = [&](uint32_t from, uint32_t to, int64_t cost, int64_t back) {
    both.push_back({from, to, cost, 0});
    both.push_back({to, from, back, 0});
  };
  for (uint32_t i = 0; i < to_source_.size(); ++i) {
    const int64_t less = std::min(to_source_[i], to_sink_[i]);
    if (to_source_[i] > less) add(0, i + 2, to_source_[i] - less, 0);
    if (to_sink_[i] > less) add(i + 2, 1, to_sink_[i] - less, 0);
  }
  for (const Pair& pair : pairs_) add(pair.from + 2, pair.to + 2, pair.cost, pair.back);
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

std::vector<bool> MinCut::Solve() const {
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

}  // namespace texgraph::textures
