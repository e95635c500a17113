#include "closedloop/inference/internal/rest_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "closedloop/inference/smooth_features.h"

namespace glisson::closedloop {
namespace {

std::size_t feature_of_time(const Observations& observations, const Eigen::MatrixXd& features);
Eigen::MatrixXd covariance_of_means(const Observations& observations, const Grouping& groups,
                                    const std::vector<std::size_t>& own, double kept);

}  // namespace

std::vector<RestBlock> blocks_of(const Observations& observations, const SystematicUncertainty& systematic,
                                 const Eigen::VectorXd& residual, const Grouping& groups, double kept) {
  const auto averaged = [&](const Eigen::MatrixXd& columns, const std::vector<std::size_t>& which) {
    Eigen::MatrixXd mean(static_cast<Eigen::Index>(which.size()), columns.cols());
    for (std::size_t i = 0; i < which.size(); ++i)
      mean.row(static_cast<Eigen::Index>(i)) = columns(groups[which[i]], Eigen::all).colwise().mean();
    return mean;
  };
  const Eigen::MatrixXd features = varying_features(observations);
  const std::size_t time = feature_of_time(observations, features);
  const Eigen::VectorXd inverse_noise = observations.noise.cwiseInverse();
  std::vector<RestBlock> blocks;
  for (int direction = 0; direction < static_cast<int>(observations.directions.size()); ++direction) {
    std::vector<std::size_t> own;
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (observations.direction[static_cast<std::size_t>(groups[g].front())] == direction) own.push_back(g);
    if (own.empty()) continue;
    RestBlock block;
    block.residual = averaged(inverse_noise.cwiseProduct(residual), own);
    const auto n = static_cast<Eigen::Index>(own.size());
    block.noise = covariance_of_means(observations, groups, own, kept);
    block.time = time;
    if (systematic.directions.cols() > 0 || systematic.shared.size() > 0) block.mesh = Eigen::MatrixXd::Zero(n, n);
    if (systematic.directions.cols() > 0) {
      const Eigen::MatrixXd off = averaged(inverse_noise.asDiagonal() * systematic.directions, own);
      block.mesh += off * off.transpose();
    }
    if (systematic.shared.size() > 0) {
      const Eigen::VectorXd shared = averaged(inverse_noise.cwiseProduct(systematic.shared), own);
      const auto group_of = [&](Eigen::Index i) {
        return systematic.group[static_cast<std::size_t>(groups[own[static_cast<std::size_t>(i)]].front())];
      };
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
          if (group_of(i) == group_of(j)) block.mesh(i, j) += shared[i] * shared[j];
    }
    const Eigen::MatrixXd at = averaged(features, own);
    for (Eigen::Index f = 0; f < at.cols(); ++f) {
      const Eigen::VectorXd x = at.col(f);
      block.square_distance.emplace_back((x.replicate(1, n) - x.transpose().replicate(n, 1)).cwiseAbs2());
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

double size_of(const std::vector<RestBlock>& blocks) {
  double square = 0, count = 0;
  for (const RestBlock& block : blocks) {
    Eigen::VectorXd expected = block.noise.diagonal();
    if (block.mesh.size() > 0) expected += block.mesh.diagonal();
    square += block.residual.cwiseAbs2().cwiseQuotient(expected).sum();
    count += static_cast<double>(block.residual.size());
  }
  return std::sqrt(square / count);
}

// Neighbours in time, of one trial, direction and place, are averaged: enough of them to leave so many groups. Where
// places are many, some of each quantity are passed over, and each of the others is left a few means.
Grouping grouped(const Observations& observations, std::size_t maximum) {
  constexpr std::size_t means_of_a_place = 3;  // the fewest that show a bend
  const bool places = observations.has_places();
  using Place = std::array<double, 3>;
  std::map<std::tuple<int, int, Place>, std::size_t> known;
  std::vector<std::vector<Eigen::Index>> series;
  for (Eigen::Index row = 0; row < observations.rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const Place place =
        places ? Place{observations.place_mm(row, 0), observations.place_mm(row, 1), observations.place_mm(row, 2)}
               : Place{};
    const auto [at, is_new] =
        known.try_emplace({observations.trial[i], observations.direction[i], place}, series.size());
    if (is_new) series.emplace_back();
    series[at->second].push_back(row);
  }
  const auto quantity_of = [&](const std::vector<Eigen::Index>& own) {
    const auto direction = static_cast<std::size_t>(observations.direction[static_cast<std::size_t>(own.front())]);
    return observations.quantities.empty() ? 0 : observations.quantities.at(direction);
  };
  std::size_t size = (static_cast<std::size_t>(observations.rows()) + maximum - 1) / maximum;
  std::map<int, std::size_t> every;  // of each quantity's places: so that a few forces are not lost among many points
  if (places) {
    std::map<int, std::size_t> count;
    std::size_t longest = 0;
    for (const auto& own : series) {
      count[quantity_of(own)] += std::min(means_of_a_place, own.size());
      longest = std::max(longest, own.size());
    }
    const std::size_t share = std::max<std::size_t>(1, maximum / count.size());
    for (const auto& [quantity, all] : count) {
      every[quantity] = (all + share - 1) / share;
      if (every[quantity] > 1) size = (longest + means_of_a_place - 1) / means_of_a_place;
    }
  }
  Grouping groups;
  std::map<int, std::size_t> passed;
  for (const auto& own : series) {
    const int quantity = quantity_of(own);
    if (places && passed[quantity]++ % every.at(quantity) != 0) continue;
    for (std::size_t first = 0; first < own.size(); first += size)
      groups.emplace_back(own.begin() + static_cast<std::ptrdiff_t>(first),
                          own.begin() + static_cast<std::ptrdiff_t>(std::min(own.size(), first + size)));
  }
  return groups;
}

namespace {

// Features have lost what they were called: time is the one that goes with it.
std::size_t feature_of_time(const Observations& observations, const Eigen::MatrixXd& features) {
  constexpr double the_same = 1 - 1e-9;
  const Eigen::VectorXd since = observations.time_s.array() - observations.time_s.mean();
  Eigen::Index f = 0;
  while (f < features.cols() && std::abs(features.col(f).dot(since)) < the_same * features.col(f).norm() * since.norm())
    ++f;
  return static_cast<std::size_t>(f);
}

// Of means over groups of samples, each of which has a variance of 1 and keeps a share of the error before it.
Eigen::MatrixXd covariance_of_means(const Observations& observations, const Grouping& groups,
                                    const std::vector<std::size_t>& own, double kept) {
  const auto n = static_cast<Eigen::Index>(own.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& first = groups[own[static_cast<std::size_t>(i)]];
    if (kept <= 0) {
      covariance(i, i) = 1 / double(first.size());
      continue;
    }
    for (Eigen::Index j = 0; j <= i; ++j) {
      const auto& second = groups[own[static_cast<std::size_t>(j)]];
      const auto a = static_cast<std::size_t>(first.front()), b = static_cast<std::size_t>(second.front());
      if (observations.trial[a] != observations.trial[b]) continue;
      double sum = 0;
      for (const Eigen::Index row : first)
        for (const Eigen::Index other : second)
          sum += std::pow(kept, std::abs(observations.sample[static_cast<std::size_t>(row)] -
                                         observations.sample[static_cast<std::size_t>(other)]));
      covariance(i, j) = covariance(j, i) = sum / double(first.size() * second.size());
    }
  }
  return covariance;
}

}  // namespace
}  // namespace glisson::closedloop
