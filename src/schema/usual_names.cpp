// Usual names: those of times with their units, of positions, of labels of curves, and of coordinates.
#include "schema/usual_names.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "text/suggest.hpp"

namespace tcb {
namespace {

/// Other usual names of times, in lower case without blanks, "_", "-" and ".".
/// A unit may follow.
constexpr std::array time_names{
    "t",
    "time",
    "times",
    "timestamp",
    "timestamps",
    "stamp",
    "stamps",
    "ts",
    "tstamp",
    "timecode",
    "timeofday",
    "clock",
    "clocktime",
    "date",
    "datetime",
    "datestamp",
    "elapsed",
    "elapsedtime",
    "timeelapsed",
    "frame",
    "frames",
    "frameno",
    "framenr",
    "framenum",
    "framenumber",
    "frameid",
    "frameidx",
    "frameindex",
    "framecount",
    "keyframe",
    "keyframes",
    "keytime",
    "keytimes",
    "keyframetime",
    "tick",
    "ticks",
    "tickcount",
    "unix",
    "unixtime",
    "unixtimestamp",
    "posixtime",
    "epoch",
    "epochtime",
    "utc",
    "utctime",
    "gpstime",
    "gmt",
    "localtime",
    "systime",
    "systemtime",
    "rostime",
    "simtime",
    "simulationtime",
    "walltime",
    "walltimes",
    "sampletime",
    "eventtime",
    "capturetime",
    "recordtime",
    "relativetime",
    "reltime",
    "absolutetime",
    "abstime",
    "tc",
    "smpte",
    "smptetimecode",
    "timevalue",
    "timepoint",
    "timesec",
    "timeindex",
    "framestamp",
    "frametime",
    "frametimestamp",
    "jdtdb",
    "jdutc",
    "juliandate",
    "mjd",
    // German, French, Spanish, Italian and Portuguese:
    "zeit",
    "uhrzeit",
    "datum",
    "zeitstempel",
    "zeitpunkt",
    "bild",
    "bildnummer",
    "temps",
    "heure",
    "horodatage",
    "tiempo",
    "hora",
    "fecha",
    "fotograma",
    "tempo",
    "ora",
    "fotogramma",
    "datahora",
    "dataora",
    "fechahora",
    "dateheure",
};

/// Names of units of time, which may be a name by themselves if they are two letters or more.
struct UnitName {
  const char* name;
  std::optional<TimeUnit> unit;
};
using enum TimeUnit;
constexpr std::array unit_names{
    UnitName{"s", s},
    UnitName{"sec", s},
    UnitName{"secs", s},
    UnitName{"second", s},
    UnitName{"seconds", s},
    UnitName{"ms", ms},
    UnitName{"msec", ms},
    UnitName{"msecs", ms},
    UnitName{"millis", ms},
    UnitName{"millisec", ms},
    UnitName{"millisecond", ms},
    UnitName{"milliseconds", ms},
    UnitName{"us", us},
    UnitName{"usec", us},
    UnitName{"usecs", us},
    UnitName{"micros", us},
    UnitName{"microsec", us},
    UnitName{"microsecond", us},
    UnitName{"microseconds", us},
    UnitName{"\u00B5s", us},
    UnitName{"\u03BCs", us},
    UnitName{"ns", ns},
    UnitName{"nsec", ns},
    UnitName{"nsecs", ns},
    UnitName{"nanos", ns},
    UnitName{"nanosec", ns},
    UnitName{"nanosecond", ns},
    UnitName{"nanoseconds", ns},
    UnitName{"minutes", minutes},
    UnitName{"hours", hours},
    UnitName{"hrs", hours},
    UnitName{"days", days},
    UnitName{"frames", frames},
    UnitName{"ticks", {}},
};

/// Units that are also words of other meanings.
constexpr std::array short_unit_names{UnitName{"m", {}},    UnitName{"min", minutes}, UnitName{"mins", minutes},
                                      UnitName{"h", hours}, UnitName{"hr", hours},    UnitName{"d", days}};

/// Names of times that count frames, in the same form as the names of times.
constexpr std::array frame_names{"frame",   "frames",     "frameno",    "framenr",    "framenum", "framenumber",
                                 "frameid", "frameidx",   "frameindex", "framecount", "keyframe", "keyframes",
                                 "bild",    "bildnummer", "fotograma",  "fotogramma"};

/// Names of arrays and objects that hold names_of_positions, in the same form.
constexpr std::array names_of_positions{"position", "positions", "pos",    "translation", "translate",  "location",
                                        "loc",      "point",     "coords", "coord",       "coordinate", "coordinates",
                                        "xyz",      "xy",        "p",      "vec",         "vector",     "value",
                                        "values",   "transform", "pose"};

/// Names of columns that distinguish curves, in the same form.
constexpr std::array label_names{"id",         "name",   "group",    "curve",   "track",  "object", "series",
                                 "trajectory", "traj",   "node",     "bone",    "joint",  "agent",  "marker",
                                 "channel",    "target", "particle", "vehicle", "actor",  "label",  "class",
                                 "key",        "no",     "nr",       "index",   "number", "sensor"};

/// Names of coordinate_names, in the same form. A column with one of them is never taken for a time.
constexpr std::array coordinate_names{
    "x",   "y",     "z",         "w",        "px",      "py",       "pz",     "tx",        "ty",   "tz",
    "rx",  "ry",    "rz",        "sx",       "sy",      "sz",       "qx",     "qy",        "qz",   "qw",
    "vx",  "vy",    "vz",        "dx",       "dy",      "dz",       "cx",     "cy",        "cz",   "ex",
    "ey",  "ez",    "r",         "g",        "b",       "a",        "lat",    "lon",       "lng",  "latitude",
    "alt", "long",  "longitude", "altitude", "easting", "northing", "height", "elevation", "roll", "pitch",
    "yaw", "value", "position",  "left",     "right",   "top",      "bottom", "width",
};

/// A name in lower case without blanks, "_", "-", ".", and a mark of comments.
std::string compact(std::string_view name) {
  std::string text;
  for (const char c : name) {
    if (std::string_view(" \t_-.%#()[]").find(c) == std::string_view::npos) text += lower(c);
  }
  return text;
}

template <std::size_t size>
bool has(const std::array<const char*, size>& names, std::string_view name) {
  return std::ranges::any_of(names, [&](std::string_view known) { return known == name; });
}

template <std::size_t size>
const UnitName* find_unit(const std::array<UnitName, size>& names, std::string_view name) {
  const auto found = std::ranges::find_if(names, [&](const UnitName& known) { return known.name == name; });
  return found == names.end() ? nullptr : &*found;
}

/// The unit at the end of a name such as "timems"; null where that is no name of a time with a unit.
const UnitName* unit_at_end(std::string_view name) {
  for (const std::string_view known : time_names) {
    if (!name.starts_with(known)) continue;
    const std::string_view text = name.substr(known.size());
    if (const UnitName* const unit = find_unit(unit_names, text)) return unit;
    const UnitName* const short_unit = known.size() > 1 ? find_unit(short_unit_names, text) : nullptr;
    if (short_unit != nullptr) return short_unit;
  }
  return nullptr;
}

/// Whether a name is that of a time, or of a time and its unit, such as "timems".
bool is_time(std::string_view name) {
  const bool is_unit = name.size() > 2 && name != "second" && find_unit(unit_names, name) != nullptr;
  return has(time_names, name) || is_unit || name == "ms" || name == "ns" || unit_at_end(name) != nullptr;
}

}  // namespace

std::string_view without_unit(std::string_view name) {
  const std::size_t begin = name.ends_with(']') ? name.rfind('[') : name.ends_with(')') ? name.rfind('(') : 0;
  if (begin == 0 || begin == std::string_view::npos) return name;
  return name.substr(0, name.find_last_not_of(' ', begin - 1) + 1);
}

bool is_usual_time(std::string_view name) {
  const std::string_view alone = without_unit(name);
  // T by itself is tension.
  if (alone == "T") return find_unit(unit_names, compact(name.substr(alone.size()))) != nullptr;
  const std::size_t path = alone.find_last_of("./");  // as in header.stamp
  const std::string last = compact(path == std::string_view::npos ? alone : alone.substr(path + 1));
  return is_time(compact(alone)) || is_time(last);
}

std::optional<TimeUnit> unit_of_time(std::string_view name) {
  const std::string_view alone = without_unit(name);
  const std::string whole = compact(name);
  const std::size_t separator = name.find_last_of("_-. ");
  const UnitName* found = nullptr;
  if (alone.size() < name.size()) {  // in brackets
    const std::string unit = compact(name.substr(alone.size()));
    found = find_unit(unit_names, unit);
    if (found == nullptr) found = find_unit(short_unit_names, unit);
  } else if (has(frame_names, whole)) {
    return TimeUnit::frames;
  } else if (separator != std::string_view::npos && is_time(compact(name.substr(0, separator)))) {  // as in t_s
    found = find_unit(unit_names, compact(name.substr(separator)));
  } else if (whole.size() > 1) {
    found = find_unit(unit_names, whole);
  }
  if (found == nullptr && !has(time_names, whole)) found = unit_at_end(whole);
  return found == nullptr ? std::nullopt : found->unit;
}

std::optional<TimePartName> time_part_of(std::string_view name) {
  constexpr std::array seconds{"sec", "secs", "seconds"};
  constexpr std::array nanoseconds{"nanosec", "nanosecs", "nsec", "nsecs", "nanos", "nanoseconds"};
  const std::size_t separator = name.find_last_of("./_ ");
  const std::string last = compact(separator == std::string_view::npos ? name : name.substr(separator + 1));
  const std::string_view stem = separator == std::string_view::npos ? "" : name.substr(0, separator);
  if (has(seconds, last)) return TimePartName{TimePart::seconds, stem};
  if (has(nanoseconds, last)) return TimePartName{TimePart::nanoseconds, stem};
  return std::nullopt;
}

bool is_usual_counter(std::string_view name) {
  const std::string last = compact(name.substr(name.find_last_of("./") + 1));
  return last == "seq" || last == "frameid";
}

std::optional<std::string> rotation_stem_of(std::string_view name, char& last) {
  std::string stem = in_lower_case(without_unit(name));
  if (stem.empty()) return std::nullopt;
  last = stem.back();
  stem.pop_back();
  const std::size_t end = stem.find_last_not_of("._- /");
  stem.resize(end == std::string::npos ? 0 : end + 1);
  constexpr std::array words{"q", "quat", "quaternion", "rot", "rotation", "orient", "orientation", "attitude"};
  const bool is_rotation = std::ranges::any_of(words, [&](std::string_view word) {
    if (!stem.ends_with(word)) return false;
    if (stem.size() == word.size() || word.size() > 4) return true;  // a long word may be the end of another
    return std::string_view("._- /").find(stem[stem.size() - word.size() - 1]) != std::string_view::npos;
  });
  return is_rotation ? std::optional(stem) : std::nullopt;
}

bool is_usual_position(std::string_view name) { return has(names_of_positions, compact(name)); }

bool is_usual_label(std::string_view name) {
  const std::string text = compact(name);
  const std::size_t separator = name.find_last_of("_-./ ");  // as in array_index
  const std::string last = separator == std::string_view::npos ? text : compact(name.substr(separator + 1));
  return has(label_names, text) || has(label_names, last) || text.ends_with("id");
}

bool tells_curves_apart(std::string_view name) {
  constexpr std::array names{"id",   "track",  "trackid",  "object",    "objectid", "name",    "curve", "curveid",
                             "uuid", "series", "deviceid", "vehicleid", "playerid", "robotid", "mmsi",  "icao24"};
  return has(names, compact(name));
}

namespace {

/// Whether a name, or its last word, is one of these.
template <std::size_t size>
bool ends_with_one(const std::array<const char*, size>& names, std::string_view name) {
  const std::string_view alone = without_unit(name);
  const std::size_t separator = alone.find_last_of("_-./ ");
  return has(names, compact(alone)) ||
         (separator != std::string_view::npos && has(names, compact(alone.substr(separator + 1))));
}

}  // namespace

bool is_usual_angle(std::string_view name) {
  constexpr std::array names{"yaw", "heading", "bearing", "azimuth", "roll", "pitch"};
  return ends_with_one(names, name);
}

std::string_view without_brackets(std::string_view text) {
  const bool has_brackets =
      text.size() >= 2 && ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
  return has_brackets ? text.substr(1, text.size() - 2) : text;
}

bool is_unit(std::string_view text) {
  constexpr std::array units{
      "s",       "sec",       "seconds",  "ms",     "us",     "\u00B5s", "\u03BCs", "ns",     "min",     "h",
      "hr",      "d",         "m",        "meter",  "meters", "mm",      "cm",      "km",     "um",      "\u00B5m",
      "\u03BCm", "in",        "ft",       "mi",     "deg",    "degree",  "degrees", "\u00B0", "rad",     "%",
      "km/h",    "kmh",       "kph",      "mph",    "kn",     "knots",   "m/s",     "mm/s",   "ft/s",    "m/s2",
      "m/s^2",   "m/s\u00B2", "g",        "kg",     "n",      "nm",      "kn",      "v",      "mv",      "a",
      "ma",      "w",         "kw",       "hz",     "khz",    "rpm",     "1/min",   "c",      "\u00B0c", "degc",
      "k",       "f",         "\u00B0f",  "pa",     "kpa",    "hpa",     "bar",     "mbar",   "psi",     "j",
      "deg/s",   "rad/s",     "\u00B0/s", "rad/s2", "px",     "pixel",   "pixels",  "ut",     "\u00B5t", "lx",
      "lux",     "db",        "l",        "l/min",  "ml",     "frames",  "utc",     "usd"};
  return has(units, in_lower_case(without_brackets(text)));
}

bool may_be_angle(std::string_view name) {
  constexpr std::array names{"lon",   "lng",     "longitude", "cog",     "course",    "track",     "pan",
                             "theta", "hue",     "rx",        "ry",      "rz",        "rotx",      "roty",
                             "rotz",  "rotatex", "rotatey",   "rotatez", "rotationx", "rotationy", "rotationz",
                             "angle", "phi",     "direction", "headyaw", "winddir",   "tilt",      "steering"};
  constexpr std::array spaces{"rotation", "rotate", "rot", "euler", "angle", "orientation"};
  if (is_usual_angle(name) || ends_with_one(names, name)) return true;
  const std::string_view alone = without_unit(name);
  const std::string whole = compact(alone);  // as in rotation_z
  return whole.size() > 1 && std::string_view("xyz").find(whole.back()) != std::string_view::npos &&
         has(spaces, std::string_view(whole).substr(0, whole.size() - 1));
}

bool is_usual_channel(std::string_view name) {
  constexpr std::array names{
      "val",   "fov",   "focal",  "focallength", "zoom",   "focus", "aperture",    "exposure", "scale",    "depth",
      "size",  "angle", "tilt",   "pan",         "alpha",  "red",   "green",       "blue",     "opacity",  "color",
      "gain",  "gray",  "weight", "intensity",   "volume", "level", "temperature", "pressure", "humidity", "speed",
      "force", "price", "close",  "distance",    "radius", "power", "current",     "voltage",  "signal",   "data"};
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string text = compact(without_unit(name));
  while (!text.empty() && is_digit(text.back())) text.pop_back();
  const std::size_t separator = name.find_last_of("_-./ ");
  const std::string last = separator == std::string_view::npos ? "" : compact(name.substr(separator + 1));
  const bool is_axis = text.size() == 2 && std::string_view("xyzw").find(text[1]) != std::string_view::npos;
  return text.size() <= 1 || is_axis || has(names, text) || has(names, last) || is_coordinate(name) ||
         is_usual_position(name) || is_usual_angle(name);
}

namespace {

/// The name of a coordinate without what tells it from the others of its space; other names are as they are.
std::string space_of(std::string_view name) {
  constexpr std::array on_earth{"lat", "lon", "lng", "long", "latitude", "longitude"};
  constexpr std::array on_maps{"easting", "northing", "east", "north"};
  std::string text = compact(without_unit(name));
  if (has(on_earth, text)) return "earth";
  if (has(on_maps, text)) return "map";
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

bool is_coordinate(std::string_view name) {
  const std::string whole = compact(without_unit(name));
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string_view text = whole;
  while (!text.empty() && is_digit(text.back())) text.remove_suffix(1);
  const bool numbered = text.size() < whole.size() && text.size() <= 3;  // as in p1
  const std::size_t separator = name.find_last_of("_-. ");
  const bool last = separator != std::string_view::npos && has(coordinate_names, compact(name.substr(separator)));
  const std::size_t first = name.find_first_of("_-. ");
  return has(coordinate_names, text) || numbered || last ||
         (first == 1 && has(coordinate_names, compact(name.substr(0, first))));
}

}  // namespace tcb
