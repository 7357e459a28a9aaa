// What every method says of the hard cases, as Markdown: the tables of docs/hard-cases.md.
//
//   hard_cases_table

#include "verdicts.hpp"

#include <iostream>
#include <map>

using namespace visibility::hard_cases;

namespace {

struct Count {
  int cases = 0, wrong = 0, missing = 0;
};

std::string mark(Verdict const& v)
{
  if (v.is_right()) return "+";
  return std::string(v.missing.empty() ? "" : "−" + std::to_string(v.missing.size())) +
         (v.extra.empty() ? "" : "+" + std::to_string(v.extra.size()));
}

}  // namespace

int main()
{
  std::vector<std::pair<std::string, std::string>> columns;
  std::map<std::pair<std::string, std::string>, std::map<std::string, Count>> counts;
  std::vector<std::string> kinds;
  struct Row {
    std::string kind, name;
    std::map<std::pair<std::string, std::string>, std::string> marks;
  };
  std::vector<Row> rows;
  for (auto const& c : all()) {
    if (kinds.empty() || kinds.back() != c.kind) kinds.push_back(c.kind);
    Row row{c.kind, c.name, {}};
    for (auto const& v : verdicts(c)) {
      std::pair const column(v.method, v.arithmetic);
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
      auto& count = counts[column][c.kind];
      ++count.cases;
      count.wrong += !v.is_right();
      count.missing += !v.missing.empty();
      row.marks[column] = mark(v);
    }
    rows.push_back(std::move(row));
  }
  std::cout << "| kind |";
  for (auto const& [method, arithmetic] : columns) std::cout << ' ' << method << ", " << arithmetic << " |";
  std::cout << "\n|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) std::cout << "---|";
  std::cout << '\n';
  for (auto const& kind : kinds) {
    std::cout << "| " << kind << " |";
    for (auto const& column : columns) {
      auto const& count = counts[column][kind];
      if (count.cases == 0)
        std::cout << " |";
      else
        std::cout << ' ' << count.cases - count.wrong << " / " << count.cases
                  << (count.missing > 0 ? ", " + std::to_string(count.missing) + " missing" : "") << " |";
    }
    std::cout << '\n';
  }
  std::cout << "\n| kind | case |";
  for (auto const& [method, arithmetic] : columns) std::cout << ' ' << method << ", " << arithmetic << " |";
  std::cout << "\n|---|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) std::cout << "---|";
  std::cout << '\n';
  for (auto const& row : rows) {
    std::cout << "| " << row.kind << " | " << row.name << " |";
    for (auto const& column : columns)
      std::cout << ' ' << (row.marks.count(column) ? row.marks.at(column) : "") << " |";
    std::cout << '\n';
  }
}
