// One background thread that sleeps when there is nothing to do. Results are joined at fixed simulated times, so a run
// does not depend on whether a thread is there.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

namespace amiss {

/// Runs jobs in the order they came: in a thread of its own, or at once in the caller when `threaded` is false.
/// `niceness`: how much nicer than the caller's that thread is, 0 to 19 (only when nobody else wants the core).
class Worker {
 public:
  explicit Worker(bool threaded, int niceness = 0);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  template <class F>
  auto submit(F job) -> std::future<decltype(job())> {
    auto task = std::make_shared<std::packaged_task<decltype(job())()>>(std::move(job));
    auto result = task->get_future();
    enqueue([task] { (*task)(); });
    return result;
  }

 private:
  void enqueue(std::function<void()> job);
  void loop();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace amiss
