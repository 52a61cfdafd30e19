// What is written beside the run: gathered in the caller, handed over in batches, written in their order by a thread
// that lets the run go first. At most one batch is being written while the next is gathered: who hands over waits for
// the one before, so nothing is lost, memory is bounded, and a batch is in the file before the one after the next
// begins. What the writer throws comes out of the next hand_over() or join().
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include "core/stamp.hpp"
#include "core/worker.hpp"

namespace amiss::recording {

/// Of simulated time, from batch to batch: one is gathered while the one before is written, so a run that is killed
/// loses at most a second.
constexpr Duration kBatchPeriod = std::chrono::milliseconds(500);

template <class Item>
class Batches {
 public:
  using Write = std::function<void(const std::vector<Item>&)>;
  /// `threaded` false: hand_over() writes at once.
  Batches(Write write, bool threaded) : write_(std::move(write)), worker_(threaded, kNiceness) {}

  void add(Item item) { gathered_.push_back(std::move(item)); }
  void hand_over() {
    join();
    if (gathered_.empty()) return;
    writing_ = worker_.submit([this, batch = std::make_shared<std::vector<Item>>(std::move(gathered_))] {
      write_(*batch);
      batch->clear();  // in this thread
    });
    gathered_ = {};
  }
  void join() {
    if (writing_.valid()) writing_.get();
  }

 private:
  static constexpr int kNiceness = 3;  // a busy machine would keep a nicer one waiting, and with it the run

  Write write_;
  std::vector<Item> gathered_;
  std::future<void> writing_;
  Worker worker_;  // the last member, so that it ends before what it works on
};

}  // namespace amiss::recording
