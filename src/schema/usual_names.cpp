// Usual names: those of times with their units, of positions, of labels of curves, and of coordinates.
#include "schema/usual_names.hpp"

#include <algorithm>
#include <array>

#include "text/suggest.hpp"

namespace tcb {
namespace {

// Names in lower case without blanks, "_", "-" and ".", as compact() makes them.

/// Usual names of times, also in German, French, Spanish, Italian and Portuguese. A unit may follow.
constexpr std::string_view time_names =
    "t time times timestamp timestamps stamp stamps ts tstamp timecode timeofday clock clocktime date datetime "
    "datestamp elapsed elapsedtime timeelapsed keytime keytimes keyframetime tick ticks tickcount unix unixtime "
    "unixtimestamp posixtime epoch epochtime utc utctime gpstime gmt localtime systime systemtime rostime simtime "
    "simulationtime walltime walltimes sampletime frametimestamps eventtime capturetime recordtime relativetime "
    "reltime absolutetime "
    "abstime timefromstart timesincestart jd tc smpte smptetimecode timevalue timepoint timesec timeindex framestamp "
    "frametime frametimestamp playhead xvalue zeit "
    "uhrzeit datum zeitstempel zeitpunkt temps heure horodatage tiempo hora fecha tempo ora "
    "datahora dataora fechahora dateheure tijd tijdstip czas coordtimes positiont";

/// The names of a unit of time; nothing: an unknown one.
struct UnitNames {
  std::optional<TimeUnit> unit;
  std::string_view names;       ///< which may be names of times by themselves if they are two letters or more
  std::string_view short_ones;  ///< which are also words of other meanings
};
using enum TimeUnit;
constexpr std::array unit_names{
    UnitNames{s, "s sec secs second seconds secondselapsed sekunde sekunden secondes segundos secondi", ""},
    UnitNames{ms, "ms msec msecs millis millisec millisecond milliseconds", ""},
    UnitNames{us, "us usec usecs micros microsec microsecond microseconds \u00B5s \u03BCs", ""},
    UnitNames{ns, "ns nsec nsecs nanos nanosec nanosecond nanoseconds", ""},
    UnitNames{minutes, "minutes", "min mins minute"},
    UnitNames{hours, "hours hrs", "h hr hour"},
    UnitNames{days, "days jd mjd hjd bjd bjdtdb jdtdb jdutc juliandate", "d day"},
    UnitNames{frames, "frames", ""},
    UnitNames{{}, "ticks", "m"}};

/// Names of parts of dates and of times of day, which are times where no other column is.
constexpr std::string_view calendar_names = "year yr month week day dayofyear doy yearday hour minute";

/// Names of times that count frames.
constexpr std::string_view frame_names =
    "frame frames frameno framenr framenum framenumber frameid frameidx frameindex framecount keyframe keyframes bild "
    "bildnummer fotograma fotogramma";

/// Names of arrays and objects that hold positions.
constexpr std::string_view names_of_positions =
    "position positions pos latlng latlon translation translate tvec location loc point coords coord coordinate "
    "coordinates xyz xy p "
    "vec vector value values transform pose";

/// Names of columns that distinguish curves.
constexpr std::string_view label_names =
    "id name group curve track object series trajectory traj node bone joint agent marker channel target particle "
    "vehicle actor label class key no nr index number sensor";

/// Names of coordinates. A column with one of them is never taken for a time.
constexpr std::string_view coordinate_names =
    "x y z w px py pz tx ty tz rx ry rz sx sy sz qx qy qz qw vx vy vz dx dy dz cx cy cz ex ey ez r g b a lat lon lng "
    "latitude alt long longitude altitude easting northing height elevation roll pitch yaw value position left right "
    "top bottom width";

/// A name in lower case without blanks, "_", "-", ".", and a mark of comments.
std::string compact(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (std::string_view(" \t_-.%#()[]<>@").find(c) == std::string_view::npos) text += lower(c);
  }
  return text;
}

/// The last word of a name as compact() makes it; empty where there is only one.
std::string last_word(std::string_view name, std::string_view separators) {
  const std::size_t separator = name.find_last_of(separators);
  return separator == std::string_view::npos ? "" : compact(name.substr(separator + 1));
}

std::string without_last_digits(std::string text) {
  while (!text.empty() && is_digit(text.back())) text.pop_back();
  return text;
}

const UnitNames* find_unit(std::string_view name, bool also_short = false) {
  const auto found = std::ranges::find_if(unit_names, [&](const UnitNames& row) {
    return lists_word(row.names, name) || (also_short && lists_word(row.short_ones, name));
  });
  return name.empty() || found == unit_names.end() ? nullptr : &*found;
}

/// The unit at the end of a name such as "timems"; null where that is no name of a time with a unit.
const UnitNames* unit_at_end(std::string_view name) {
  for (std::size_t size = 1; size < name.size(); ++size) {
    const std::string_view time = name.substr(0, size);
    if (!lists_word(time_names, time) && !lists_word(frame_names, time)) continue;
    if (const UnitNames* const unit = find_unit(name.substr(size), size > 1)) return unit;
  }
  return nullptr;
}

/// The unit of a name, as without_unit() leaves it out, with its brackets; empty where there is none.
std::string_view unit_beside(std::string_view name) {
  name.remove_prefix(without_unit(name).size());
  name.remove_prefix(std::min(name.find_first_not_of(" ,/"), name.size()));
  if (name.starts_with("in ")) name.remove_prefix(3);
  return name;
}

/// Whether a name is that of a time, or of a time and its unit, such as "timems".
bool is_time(std::string_view name) {
  if (lists_word(time_names, name) || lists_word(frame_names, name) || name == "ms" || name == "ns") return true;
  const bool is_unit = name.size() > 2 && name != "second" && find_unit(name) != nullptr;
  return is_unit || unit_at_end(name) != nullptr;
}

}  // namespace

std::string_view without_unit(std::string_view name) {
  if (const std::size_t comma = name.find(", "); comma != std::string_view::npos) return name.substr(0, comma);
  if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos && slash > 0) {  // as in t / s
    const std::size_t unit = name.find_first_not_of(' ', slash + 1);
    if (unit != std::string_view::npos && is_unit(name.substr(unit))) {
      return name.substr(0, name.find_last_not_of(' ', slash - 1) + 1);
    }
  }
  if (const std::size_t in = name.rfind(" in "); in != std::string_view::npos && is_unit(name.substr(in + 4))) {
    return name.substr(0, in);
  }
  const std::size_t begin = name.ends_with(']') ? name.rfind('[') : name.ends_with(')') ? name.rfind('(') : 0;
  if (begin == 0 || begin == std::string_view::npos) return name;
  return name.substr(0, name.find_last_not_of(' ', begin - 1) + 1);
}

std::optional<std::size_t> find_without_unit(std::span<const std::string> names, std::string_view name) {
  const auto is_same = [&](const std::string& other) { return same_in_any_case(without_unit(other), name); };
  const auto found = std::ranges::find_if(names, is_same);
  if (found == names.end() || std::any_of(found + 1, names.end(), is_same)) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

bool is_usual_time(std::string_view name) {
  std::string_view alone = without_unit(name);
  constexpr std::size_t most_digits = 4;
  const std::size_t sign = alone.find_last_of("-+");
  const std::string_view digits = alone.substr(std::min(sign, alone.size() - 1) + 1);
  const bool has_origin =
      digits.size() >= most_digits && digits.find_first_not_of("0123456789") == std::string_view::npos;
  if (has_origin && sign != std::string_view::npos) alone = alone.substr(0, sign);  // as in JD-2450000
  // T by itself is tension.
  if (alone == "T") return unit_of_time(name).has_value();
  const std::size_t path = alone.find_last_of("./");  // as in header.stamp
  if (path != std::string_view::npos && is_time(compact(alone.substr(path + 1)))) return true;
  const bool is_part = path != std::string_view::npos && is_coordinate(alone.substr(0, path));  // as in x.value
  return !is_part && is_time(compact(alone));
}

std::optional<TimeUnit> unit_of_time(std::string_view name) {
  const std::string_view alone = without_unit(name);
  const std::string whole = compact(name);
  const std::size_t separator = name.find_last_of("_-. ");
  const UnitNames* found = nullptr;
  if (alone.size() < name.size()) {  // in brackets
    found = find_unit(compact(unit_beside(name)), true);
    if (found == nullptr && compact(alone).size() > 1) found = find_unit(compact(alone));  // as in JD(TT)
  } else if (lists_word(frame_names, whole)) {
    return TimeUnit::frames;
  } else if (separator != std::string_view::npos && is_time(compact(name.substr(0, separator)))) {  // as in t_s
    found = find_unit(compact(name.substr(separator)));
    if (found == nullptr) found = find_unit(whole);
  } else if (whole.size() > 1) {
    found = find_unit(whole, lists_word(calendar_names, whole));
  }
  if (found == nullptr && !lists_word(time_names, whole)) found = unit_at_end(whole);
  return found == nullptr ? std::nullopt : found->unit;
}

bool names_calendar(std::string_view name) { return lists_word(calendar_names, compact(without_unit(name))); }

std::optional<TimePartName> time_part_of(std::string_view name) {
  constexpr std::string_view seconds = "sec secs seconds";
  constexpr std::string_view nanoseconds = "nanosec nanosecs nsec nsecs nanos nanoseconds";
  const std::size_t separator = name.find_last_of("./_ ");
  const std::string last = compact(separator == std::string_view::npos ? name : name.substr(separator + 1));
  const std::string_view stem = separator == std::string_view::npos ? "" : name.substr(0, separator);
  if (lists_word(seconds, last)) return TimePartName{TimePart::seconds, stem};
  if (lists_word(nanoseconds, last)) return TimePartName{TimePart::nanoseconds, stem};
  return std::nullopt;
}

bool is_usual_counter(std::string_view name) {
  const std::string last = compact(name.substr(name.find_last_of("./") + 1));
  return last == "seq" || last == "frameid";
}

bool names_record(std::string_view name) {
  constexpr std::string_view names = "id record rn scan recno sampleno #";
  const bool has_hash = name == "#";
  return has_hash || lists_word(names, compact(name)) || lists_word("id record scan no", last_word(name, "_-./ "));
}

std::optional<std::pair<std::string, char>> rotation_stem_of(std::string_view name) {
  std::string stem = in_lower_case(without_unit(name));
  if (stem.empty()) return std::nullopt;
  const char last = stem.back();
  stem.pop_back();
  const std::size_t end = stem.find_last_not_of("._- /");
  stem.resize(end == std::string::npos ? 0 : end + 1);
  constexpr std::array<std::string_view, 8> words{"q",        "quat",   "quaternion",  "rot",
                                                  "rotation", "orient", "orientation", "attitude"};
  const bool is_rotation = std::ranges::any_of(words, [&](std::string_view word) {
    if (!stem.ends_with(word)) return false;
    if (stem.size() == word.size() || word.size() > 4) return true;  // a long word may be the end of another
    return std::string_view("._- /").find(stem[stem.size() - word.size() - 1]) != std::string_view::npos;
  });
  return is_rotation ? std::optional(std::pair(stem, last)) : std::nullopt;
}

bool is_usual_position(std::string_view name) { return lists_word(names_of_positions, compact(name)); }

bool is_usual_label(std::string_view name) {
  const std::string text = compact(name);
  return lists_word(label_names, text) || lists_word(label_names, last_word(name, "_-./ ")) || text.ends_with("id");
}

bool tells_curves_apart(std::string_view name) {
  constexpr std::string_view names =
      "id track trackid object objectid name curve curveid uuid series deviceid vehicleid playerid robotid mmsi icao24";
  return lists_word(names, compact(name));
}

namespace {

/// Whether a name, or its last word, is one of these; a unit of angles may follow.
bool ends_with_one(std::string_view names, std::string_view name) {
  std::string_view alone = without_unit(name);
  for (const std::string_view unit : {"_deg", "_degrees", "_rad", "_radians"}) {
    if (alone.ends_with(unit)) alone.remove_suffix(unit.size());
  }
  return lists_word(names, compact(alone)) || lists_word(names, last_word(alone, "_-./ "));
}

}  // namespace

bool names_dates(std::string_view name) {
  constexpr std::string_view names = "date datum fecha data yyyymmdd dateutc";
  return ends_with_one(names, name);
}

bool ends_like_time(std::string_view name) {
  return ends_with_one("time timestamp stamp date datetime", name) || compact(without_unit(name)).ends_with("time");
}

bool is_usual_angle(std::string_view name) {
  constexpr std::string_view names = "yaw heading bearing azimuth roll pitch";
  return ends_with_one(names, name);
}

bool is_of_rotation_vector(std::string_view name) {
  constexpr std::string_view stems = "rvec rotvec rodrigues rotationvector";
  const std::string text = compact(without_unit(name.substr(name.find_last_of("/") + 1)));
  return !text.empty() && lists_word(stems, std::string_view(text).substr(0, text.size() - 1));
}

std::string_view without_brackets(std::string_view text) {
  const bool has_brackets =
      text.size() >= 2 && ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
  return has_brackets ? text.substr(1, text.size() - 2) : text;
}

bool is_unit(std::string_view text) {
  constexpr std::string_view units =
      "s sec seconds ms us \u00B5s \u03BCs ns min h hr d m meter meters mm cm km um \u00B5m \u03BCm in ft mi deg "
      "degree degrees \u00B0 rad % km/h kmh kph mph kn knots m/s mm/s ft/s m/s2 m/s^2 m/s\u00B2 g kg n nm v mv a ma w "
      "kw hz khz rpm 1/min c \u00B0c degc k f \u00B0f pa kpa hpa bar mbar psi j deg/s rad/s \u00B0/s rad/s2 px pixel "
      "pixels ut \u00B5t lx lux db l l/min ml frames utc usd \u2103 mw uw \u00B5w w/m2 w/m\u00B2 ua \u00B5a na uv "
      "\u00B5v j kj wh kwh ah mah mg ug \u00B5g ppm ppb mol ohm kohm \u03A9 k\u03A9 us/cm \u00B5s/cm ms/cm mg/l ghz "
      "dbm gpa n/mm2 n/mm\u00B2 \u20AC $ \u00A3 inhg mmhg torr atm yd in/s g/cm3 g/cm\u00B3 m2 m\u00B2 cm2 cm\u00B2 "
      "mm2 mm\u00B2 um2 \u00B5m\u00B2 px2";
  return lists_word(units, in_lower_case(without_brackets(text)));
}

bool are_units(std::span<const std::string_view> cells) {
  // The words of the lines below the names in files of Campbell Scientific: of times, of record numbers, of processing.
  constexpr std::string_view words =
      "ts rn degc smp avg max min std tot med wvc w/m^2 m^3/m^3 meters/second volts amps watts";
  const auto is_empty = [](std::string_view cell) { return cell.empty() || cell == "-" || cell == "none"; };
  const auto fits = [&](std::string_view cell) {
    const std::string_view text = cell.size() > 1 && cell.front() == '"' ? cell.substr(1, cell.size() - 2) : cell;
    return is_empty(text) || is_unit(text) || is_unit(compact(text)) || lists_word(words, compact(text));
  };
  return !std::ranges::all_of(cells, is_empty) && std::ranges::all_of(cells, fits);
}

bool is_in_degrees(std::string_view name) {
  constexpr std::string_view units = "deg degs degree degrees \u00B0";
  return lists_word(units, compact(unit_beside(name))) || lists_word(units, last_word(name, "_-. "));
}

bool may_be_angle(std::string_view name) {
  constexpr std::string_view names =
      "lon lng longitude ra rightascension az cog course track pan theta hue rx ry rz rotx roty rotz rotatex rotatey "
      "rotatez rotationx rotationy rotationz angle phi direction headyaw winddir tilt steering";
  constexpr std::string_view spaces = "rotation rotate rot euler angle orientation";
  if (is_usual_angle(name) || ends_with_one(names, name)) return true;
  constexpr std::string_view units = "deg degree degrees \u00B0 rad radians";
  if (lists_word(units, compact(unit_beside(name)))) return true;  // as in RA [deg]
  const std::string whole = compact(without_unit(name));           // as in rotation_z
  const bool ends_in_axis = whole.size() > 1 && std::string_view("xyz").find(whole.back()) != std::string_view::npos;
  if (ends_in_axis && lists_word(spaces, std::string_view(whole).substr(0, whole.size() - 1))) return true;
  const auto ends_with = [&](std::string_view word) {  // as in Hips.Yrotation and arm.rotation.x
    return whole.ends_with(word) ||
           (ends_in_axis && std::string_view(whole).substr(0, whole.size() - 1).ends_with(word));
  };
  return ends_with("rotation") || ends_with("euler");
}

bool is_usual_channel(std::string_view name) {
  constexpr std::string_view names =
      "val fov focal focallength zoom focus aperture exposure scale depth size angle tilt pan alpha red green blue "
      "opacity color gain gray weight intensity volume level temperature pressure humidity speed force price close "
      "distance radius power current voltage signal data";
  const std::string text = without_last_digits(compact(without_unit(name)));
  const bool is_axis = text.size() == 2 && std::string_view("xyzw").find(text[1]) != std::string_view::npos;
  return text.size() <= 1 || is_axis || lists_word(names, text) || lists_word(names, last_word(name, "_-./ ")) ||
         is_coordinate(name) || is_usual_position(name) || is_usual_angle(name);
}

namespace {

/// A name such as "x_m" without its unit of length.
std::string_view without_length_unit(std::string_view name) {
  name = without_unit(name);
  for (const std::string_view unit : {"_m", "_mm", "_cm", "_km"}) {
    if (name.ends_with(unit)) name.remove_suffix(unit.size());
  }
  return name;
}

/// The name of a coordinate without what tells it from the others of its space; other names are as they are.
std::string space_of(std::string_view name) {
  constexpr std::string_view on_earth = "lat lon lng long latitude longitude";
  constexpr std::string_view on_maps = "easting northing east north";
  std::string text = compact(without_length_unit(name));
  if (lists_word(on_earth, text)) return "earth";
  if (lists_word(on_maps, text)) return "map";
  if (text.size() == 1) return "";
  if (std::string_view("xyzw0123456789").find(text.back()) != std::string_view::npos) {
    text.pop_back();
  } else if (std::string_view("xyz").find(text.front()) != std::string_view::npos && name.size() > 1 &&
             std::string_view("_-. ").find(name[1]) != std::string_view::npos) {  // as in x_pos
    text.erase(0, 1);
  }
  return text;
}

}  // namespace

bool are_of_one_kind(std::string_view one, std::string_view other) { return space_of(one) == space_of(other); }

std::vector<std::size_t> spatial_channels(const std::vector<std::string>& channels) {
  std::vector<std::string> names;
  for (const std::string& channel : channels) {
    names.push_back(compact(without_length_unit(channel)));
  }
  const auto find = [&](const std::string& name) { return std::ranges::find(names, name) - names.begin(); };
  // Before the letter of an axis, in the order in which one is chosen.
  for (const std::string stem : {"", "p", "pos", "position", "loc", "location", "t", "translation"}) {
    std::vector<std::size_t> space;
    for (const auto channel : {find(stem + "x"), find(stem + "y"), find(stem + "z")}) {
      if (channel < std::ssize(names)) space.push_back(static_cast<std::size_t>(channel));
    }
    if (find(stem + "x") == std::ssize(names) || find(stem + "y") == std::ssize(names)) continue;
    return space.size() < channels.size() ? space : std::vector<std::size_t>{};
  }
  return {};
}

bool is_coordinate(std::string_view name) {
  const std::string whole = compact(without_unit(name));
  const std::string text = without_last_digits(whole);
  const bool numbered = text.size() < whole.size() && text.size() <= 3 && whole.size() <= text.size() + 3;  // as in p1
  const std::size_t first = name.find_first_of("_-. ");
  return lists_word(coordinate_names, text) || numbered || lists_word(coordinate_names, last_word(name, "_-. ")) ||
         (first == 1 && lists_word(coordinate_names, compact(name.substr(0, first))));
}

}  // namespace tcb
