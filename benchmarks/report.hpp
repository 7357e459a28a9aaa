#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace visibility::bench {

/// A cell of a table: text, a number, or nothing (not measured, not in the paper).
using Value = std::variant<std::monostate, double, std::string>;

/// Tables of one benchmark: printed for people, written as JSON with the machine, the compiler and the command.
class Report {
public:
  struct Table {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<Value>> rows;
    std::vector<std::string> notes;
    void add(std::vector<Value> row) { rows.push_back(std::move(row)); }
  };

  Report(std::string name, std::string command) : name_(std::move(name)), command_(std::move(command)) {}

  /// The reference holds until the next call.
  Table& table(std::string title, std::vector<std::string> columns)
  {
    return tables_.emplace_back(Table{std::move(title), std::move(columns), {}, {}});
  }

  void print(std::ostream& out) const
  {
    for (auto const& t : tables_) {
      out << '\n' << t.title << '\n';
      std::vector<std::size_t> width;
      for (auto const& c : t.columns) width.push_back(c.size());
      for (auto const& row : t.rows)
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], text(row[i]).size());
      auto const line = [&](auto const& cells, auto&& as_text) {
        for (std::size_t i = 0; i < cells.size(); ++i)
          out << (i == 0 ? "" : "  ") << (i == 0 ? std::left : std::right) << std::setw(static_cast<int>(width[i]))
              << as_text(cells[i]);
        out << '\n';
      };
      line(t.columns, [](std::string const& s) { return s; });
      for (auto const& row : t.rows) line(row, text);
      for (auto const& n : t.notes) out << "  " << n << '\n';
    }
  }

  /// Throws std::runtime_error if the file cannot be written.
  void write_json(std::string const& file) const
  {
    nlohmann::ordered_json j{{"format", "visibility-benchmark/1"},
                             {"benchmark", name_},
                             {"command", command_},
                             {"machine", cpu()},
                             {"threads", std::thread::hardware_concurrency()},
                             {"compiler", compiler()},
                             {"commit", VISIBILITY_COMMIT}};
    j["tables"] = nlohmann::ordered_json::array();
    for (auto const& t : tables_) {
      nlohmann::ordered_json rows = nlohmann::ordered_json::array();
      for (auto const& row : t.rows) {
        nlohmann::ordered_json r = nlohmann::ordered_json::array();
        for (auto const& v : row) r.push_back(json(v));
        rows.push_back(std::move(r));
      }
      j["tables"].push_back({{"title", t.title}, {"columns", t.columns}, {"rows", rows}, {"notes", t.notes}});
    }
    std::ofstream out(file);
    if (!(out << j.dump(1) << '\n')) throw std::runtime_error(file + ": cannot write this file");
  }

private:
  static std::string text(Value const& v)
  {
    if (auto const* s = std::get_if<std::string>(&v)) return *s;
    if (auto const* d = std::get_if<double>(&v)) {
      std::ostringstream out;
      // Counts in full, measurements with three or four digits.
      if (*d == std::floor(*d) && std::fabs(*d) < 1e12)
        out << std::fixed << std::setprecision(0) << *d;
      else
        out << std::setprecision(std::fabs(*d) < 1000 ? 3 : 4) << *d;
      return out.str();
    }
    return "-";
  }
  static nlohmann::ordered_json json(Value const& v)
  {
    if (auto const* s = std::get_if<std::string>(&v)) return *s;
    if (auto const* d = std::get_if<double>(&v)) return *d;
    return nullptr;
  }
  static std::string cpu()
  {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
  }
  static std::string compiler()
  {
#ifdef __clang__
    return std::string("clang ") + __clang_version__;
#else
    return std::string("gcc ") + __VERSION__;
#endif
  }

  std::string name_, command_;
  std::vector<Table> tables_;
};

/// Processor time of the whole process, for work on one core of a machine that is shared with others.
struct ProcessorClock {
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<ProcessorClock, duration>;
  static time_point now()
  {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return time_point(std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec));
  }
};

/// Seconds of `run`, the median of several runs: `runs`, or fewer once `budget` seconds are spent, at least one.
template <class Clock = std::chrono::steady_clock, class Run>
double median_seconds(int runs, double budget, Run&& run)
{
  std::vector<double> times;
  double spent = 0;
  while (static_cast<int>(times.size()) < runs && (times.empty() || spent < budget)) {
    auto const start = Clock::now();
    run();
    times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    spent += times.back();
  }
  std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
  return times[times.size() / 2];
}

/// Median seconds of each of two, run in turn, so that a machine that slows down slows both.
template <class Clock = std::chrono::steady_clock, class A, class B>
std::pair<double, double> medians_in_turn(int runs, A&& a, B&& b)
{
  std::vector<double> of_a, of_b;
  for (int i = 0; i < runs; ++i) {
    of_a.push_back(median_seconds<Clock>(1, 0, a));
    of_b.push_back(median_seconds<Clock>(1, 0, b));
  }
  std::ranges::sort(of_a);
  std::ranges::sort(of_b);
  return {of_a[of_a.size() / 2], of_b[of_b.size() / 2]};
}

}  // namespace visibility::bench
