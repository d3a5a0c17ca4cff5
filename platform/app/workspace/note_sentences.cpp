#include "app/workspace/note_sentences.h"

#include <algorithm>
#include <utility>

namespace lacuna {

std::vector<std::string> note_sentences(const std::vector<ReadingNote>& notes) {
  struct Noticed {
    std::string message;
    std::vector<std::string> places;
  };
  std::vector<Noticed> all;
  for (const ReadingNote& note : notes) {
    auto known = std::ranges::find(all, note.message, &Noticed::message);
    if (known == all.end()) known = all.insert(all.end(), {note.message, {}});
    std::string place = to_string(note.location);
    if (std::ranges::find(known->places, place) == known->places.end()) known->places.push_back(std::move(place));
  }
  std::vector<std::string> sentences;
  for (const Noticed& one : all) {
    std::string& sentence = sentences.emplace_back();
    for (const std::string& place : one.places) sentence += (sentence.empty() ? "" : ", ") + place;
    sentence += ": " + one.message;
  }
  return sentences;
}

}  // namespace lacuna
