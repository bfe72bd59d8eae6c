// Wire format: a request is a number of triangles (8 bytes), 0 = verify; an answer is a kind (1 byte), a length (4 bytes),
// and the bytes of a plain struct, of a line of text or of an error record.
#include "harness/bench/driver_process.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "harness/bench/contender.hpp"
#include "harness/bench/machine.hpp"
#include "harness/bench/truth.hpp"
#include "harness/cli/isolated.hpp"
#include "harness/pipe_bytes.hpp"
#include "harness/report/record.hpp"

namespace rasterdiff::harness::bench {
namespace {

constexpr char kGood = '+', kError = '-';

void reply(int fd, char kind, const std::string& payload) {
  const auto length = static_cast<uint32_t>(payload.size());
  std::string bytes(1, kind);
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length).append(payload);
  (void)writeFully(fd, bytes.data(), bytes.size());  // a parent that is gone wants no answer
}

template <class T>
std::string bytesOf(const T& plain) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&plain), sizeof plain};
}

template <class T>
Result<T> plainOf(const Result<std::string>& bytes) {
  if (!bytes) return tl::unexpected(bytes.error());
  T plain;
  if (bytes->size() != sizeof plain) return fail(ErrorCode::DeviceLost, {}, "the driver's process answered nonsense");
  std::memcpy(&plain, bytes->data(), sizeof plain);
  return plain;
}

/// `threads` cores of those that there are. lavapipe reads its own number of threads: 0 = draw on the calling thread.
void restrictThreads(unsigned threads) {
  setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 1);
  cpu_set_t offered, used;
  CPU_ZERO(&offered);
  CPU_ZERO(&used);
  if (sched_getaffinity(0, sizeof offered, &offered) != 0) return;
  for (size_t core = CPU_SETSIZE; core-- > 0 && CPU_COUNT(&used) < static_cast<int>(threads);)
    if (CPU_ISSET(core, &offered)) CPU_SET(core, &used);
  sched_setaffinity(0, sizeof used, &used);
}

/// The life of the child.
void serve(const DriverProcess::Job& job, int requests, int answers) {
  restrictThreads(job.threads);
  const PeakMeter meter;
  Result<std::unique_ptr<Subject>> subject = openSubject(job.driver);
  if (!subject) return reply(answers, kError, recordOf(subject.error()));
  Subject& driver = *subject->release();  // the process ends with the work
  reply(answers, kGood, subjectLine(driver));
  Scene scene;
  std::optional<uint64_t> sceneOfTriangles;
  for (uint64_t triangles = 0;;) {
    if (!readFully(requests, reinterpret_cast<char*>(&triangles), sizeof triangles)) return;
    const uint64_t wanted = triangles == 0 ? job.verified : triangles;
    if (wanted != sceneOfTriangles) scene = sceneOf(*job.load, job.task, wanted);
    sceneOfTriangles = wanted;
    Result<Frame> frame;
    DriverProcess::Drawn drawn;
    drawn.wholeSeconds = secondsOf([&] { frame = driver.render(scene); });
    drawn.drawSeconds = driver.driverSeconds().value_or(DriverSeconds{}).drawing;
    drawn.peakBytes = meter.growth().value_or(0);
    if (!frame) {
      reply(answers, kError, recordOf(frame.error()));
    } else {
      reply(answers, kGood, triangles == 0 ? bytesOf(difference(*job.expected, *frame)) : bytesOf(drawn));
    }
  }
}

}  // namespace

DriverProcess::DriverProcess(DriverProcess&& other) noexcept
    : child_(std::exchange(other.child_, {})), seconds_(other.seconds_), line_(std::move(other.line_)) {}

DriverProcess::~DriverProcess() {
  if (child_.pid > 0) (void)cli::endChild(child_);
}

Result<DriverProcess> DriverProcess::open(const Job& job) {
  std::signal(SIGPIPE, SIG_IGN);  // a dead child is found out by what write returns
  const cli::Child child = cli::startChild({}, [&](int requests, int answers) { serve(job, requests, answers); });
  if (child.pid < 0) return fail(ErrorCode::DeviceLost, {}, "the driver's process could not be started");
  DriverProcess process(child, cli::watchdogSeconds(job.driver.timeoutSeconds));
  Result<std::string> line = process.answer();
  if (!line) return tl::unexpected(line.error());
  process.line_ = std::move(*line);
  return process;
}

Result<DriverProcess::Drawn> DriverProcess::draw(size_t triangles) { return plainOf<Drawn>(ask(triangles)); }

Result<ErrorCount> DriverProcess::verify() { return plainOf<ErrorCount>(ask(0)); }

Result<std::string> DriverProcess::ask(uint64_t triangles) {
  if (child_.pid < 0) return fail(ErrorCode::DeviceLost, {}, "the driver's process has ended");
  if (!writeFully(child_.jobs, reinterpret_cast<const char*>(&triangles), sizeof triangles)) return tl::unexpected(death(false));
  return answer();
}

Result<std::string> DriverProcess::answer() {
  constexpr uint32_t kLongest = 1U << 20;
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                            std::chrono::duration<double>(seconds_));
  char head[1 + sizeof(uint32_t)];
  uint32_t length = 0;
  std::string payload;
  bool good = readFully(child_.messages, head, sizeof head, until);
  if (good) {
    std::memcpy(&length, head + 1, sizeof length);
    good = length <= kLongest;
  }
  if (good) {
    payload.resize(length);
    good = readFully(child_.messages, payload.data(), length, until);
  }
  if (!good) return tl::unexpected(death(std::chrono::steady_clock::now() >= until));
  if (head[0] == kGood) return payload;
  const Result<Error> error = readErrorRecord(payload);
  return tl::unexpected(error ? *error : error.error());
}

Error DriverProcess::death(bool timedOut) {
  const std::string words = cli::lastWords(child_), how = cli::endChild(child_);
  const std::string what = timedOut ? fmt::format("no answer within {:.0f} s", seconds_) : how.empty() ? "its process ended" : how;
  return {timedOut ? ErrorCode::TimedOut : ErrorCode::DeviceLost, {},
          fmt::format("the driver {}: {}{}", timedOut ? "hung" : "crashed", what, words.empty() ? "" : "; last words: " + words),
          "rasterdiff devices"};
}

}  // namespace rasterdiff::harness::bench
