#include "drm_card.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <set>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <xf86drm.h>

#include "screen_choice.h"

namespace vitrine {
namespace {

// What libdrm allocates, freed by the function that goes with it.
template <auto kFree>
struct FreedBy {
  template <class Object>
  void operator()(Object* object) const {
    kFree(object);
  }
};
using Resources = std::unique_ptr<drmModeRes, FreedBy<drmModeFreeResources>>;
using ConnectorPointer = std::unique_ptr<drmModeConnector, FreedBy<drmModeFreeConnector>>;
using EncoderPointer = std::unique_ptr<drmModeEncoder, FreedBy<drmModeFreeEncoder>>;
using PlaneResources = std::unique_ptr<drmModePlaneRes, FreedBy<drmModeFreePlaneResources>>;
using PlanePointer = std::unique_ptr<drmModePlane, FreedBy<drmModeFreePlane>>;
using Properties = std::unique_ptr<drmModeObjectProperties, FreedBy<drmModeFreeObjectProperties>>;
using PropertyPointer = std::unique_ptr<drmModePropertyRes, FreedBy<drmModeFreeProperty>>;
using Version = std::unique_ptr<drmVersion, FreedBy<drmFreeVersion>>;

ScreenMode mode_of(const drmModeModeInfo& timing) {
  ScreenMode mode{.width = timing.hdisplay,
                  .height = timing.vdisplay,
                  .refresh_hz = static_cast<double>(timing.vrefresh),
                  .preferred = (timing.type & DRM_MODE_TYPE_PREFERRED) != 0,
                  .interlaced = (timing.flags & DRM_MODE_FLAG_INTERLACE) != 0};
  // From the clock where there is one: `vrefresh` is rounded to a whole number.
  const double lines = static_cast<double>(timing.htotal) * timing.vtotal;
  if (timing.clock > 0 && lines > 0.0) {
    mode.refresh_hz = timing.clock * 1000.0 / lines;
    if (mode.interlaced) mode.refresh_hz *= 2.0;
    if ((timing.flags & DRM_MODE_FLAG_DBLSCAN) != 0) mode.refresh_hz /= 2.0;
    if (timing.vscan > 1) mode.refresh_hz /= timing.vscan;
  }
  return mode;
}

Plugged plugged_of(const drmModeConnector& connector) {
  if (connector.connection == DRM_MODE_CONNECTED) return Plugged::kYes;
  return connector.connection == DRM_MODE_DISCONNECTED ? Plugged::kNo : Plugged::kUnknown;
}

std::string name_of(const drmModeConnector& connector) {
  const char* const type = drmModeGetConnectorTypeName(connector.connector_type);
  return std::string(type != nullptr ? type : "Unknown") + "-" + std::to_string(connector.connector_type_id);
}

/// The place of a device file's device: "pci 0000:00:02.0".
std::string bus_of(int fd) {
  struct stat status {};
  if (fstat(fd, &status) != 0) return "";
  const std::filesystem::path device = "/sys/dev/char/" + std::to_string(major(status.st_rdev)) + ":" +
                                       std::to_string(minor(status.st_rdev)) + "/device";
  std::error_code none;
  const std::filesystem::path place = std::filesystem::canonical(device, none);
  if (none) return "";
  const std::filesystem::path bus = std::filesystem::canonical(device / "subsystem", none);
  return (none ? "" : bus.filename().string() + " ") + place.filename().string();
}

bool is_primary(int fd, std::uint32_t plane) {
  const Properties properties(drmModeObjectGetProperties(fd, plane, DRM_MODE_OBJECT_PLANE));
  if (!properties) return false;
  for (std::uint32_t i = 0; i < properties->count_props; ++i) {
    const PropertyPointer property(drmModeGetProperty(fd, properties->props[i]));
    if (property && std::strcmp(property->name, "type") == 0) {
      return properties->prop_values[i] == DRM_PLANE_TYPE_PRIMARY;
    }
  }
  return false;
}

}  // namespace

DrmCard::DrmCard(const std::filesystem::path& path)
    : path_(path), file_(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK)) {
  if (!file_) {
    const std::string why = path.string() + " cannot be opened: " + std::strerror(errno);
    throw DisplayUnavailable(why +
                             (errno == EACCES ? "; join the group 'video'" : "; check 'ls -l /dev/dri'"));
  }
  const Version version(drmGetVersion(fd()));
  if (version) driver_.assign(version->name, static_cast<std::size_t>(version->name_len));
  const Resources resources(drmModeGetResources(fd()));
  std::uint64_t dumb = 0;
  if (!resources || resources->count_crtcs == 0 || resources->count_connectors == 0) {
    throw DisplayUnavailable(path.string() + " (" + driver_ + ") has no outputs; use another card");
  }
  if (drmGetCap(fd(), DRM_CAP_DUMB_BUFFER, &dumb) != 0 || dumb == 0) {
    throw DisplayUnavailable(path.string() + " (" + driver_ + ") has no dumb buffers; use another card");
  }
  drmSetClientCap(fd(), DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1);  // where refused, formats_of() finds no plane
  std::uint64_t bits = 0;
  if (drmGetCap(fd(), DRM_CAP_DUMB_PREFERRED_DEPTH, &bits) == 0) preferred_bits_ = static_cast<int>(bits);
}

std::vector<DrmCard::Connector> DrmCard::connectors(Probe probe) const {
  const Resources resources(drmModeGetResources(fd()));
  if (!resources) return {};
  struct Read {
    ConnectorPointer pointer;
    std::uint32_t driven_by = 0;  // the CRTC that shows on it now, or 0
  };
  std::vector<Read> reads;
  std::set<std::uint32_t> taken;
  for (int i = 0; i < resources->count_connectors; ++i) {
    const std::uint32_t id = resources->connectors[i];
    Read read{.pointer = ConnectorPointer(probe == Probe::kAnew ? drmModeGetConnector(fd(), id)
                                                                : drmModeGetConnectorCurrent(fd(), id))};
    if (!read.pointer || read.pointer->connector_type == DRM_MODE_CONNECTOR_WRITEBACK) continue;
    // Without an encoder now (its id is 0) a connector may be as good as any.
    const EncoderPointer encoder(drmModeGetEncoder(fd(), read.pointer->encoder_id));
    if (encoder) read.driven_by = encoder->crtc_id;
    if (read.driven_by != 0) taken.insert(read.driven_by);
    reads.push_back(std::move(read));
  }

  std::vector<Connector> connectors;
  for (const Read& read : reads) {
    Connector connector{.id = read.pointer->connector_id,
                        .info = {.name = name_of(*read.pointer), .plugged = plugged_of(*read.pointer)}};
    for (int i = 0; i < read.pointer->count_modes; ++i) {
      connector.timings.push_back(read.pointer->modes[i]);
      connector.info.modes.push_back(mode_of(read.pointer->modes[i]));
    }
    std::uint32_t possible = 0;
    for (int i = 0; i < read.pointer->count_encoders; ++i) {
      const EncoderPointer encoder(drmModeGetEncoder(fd(), read.pointer->encoders[i]));
      if (encoder) possible |= encoder->possible_crtcs;
    }
    for (int i = 0; i < std::min(resources->count_crtcs, 32); ++i) {
      if ((possible >> i & 1U) != 0) connector.crtcs.push_back(resources->crtcs[i]);
    }
    // First the one that it has, then those that nobody has.
    std::ranges::stable_sort(connector.crtcs, {}, [&](std::uint32_t crtc) {
      return crtc == read.driven_by ? 0 : taken.contains(crtc) ? 2 : 1;
    });
    connectors.push_back(std::move(connector));
  }
  return connectors;
}

std::vector<std::uint32_t> DrmCard::formats_of(std::uint32_t crtc) const {
  const Resources resources(drmModeGetResources(fd()));
  const PlaneResources planes(drmModeGetPlaneResources(fd()));
  if (resources && planes) {
    const std::span crtcs(resources->crtcs, static_cast<std::size_t>(resources->count_crtcs));
    const auto index = static_cast<unsigned>(std::ranges::find(crtcs, crtc) - crtcs.begin());
    for (std::uint32_t i = 0; i < planes->count_planes; ++i) {
      const PlanePointer plane(drmModeGetPlane(fd(), planes->planes[i]));
      if (!plane || index >= 32 || (plane->possible_crtcs >> index & 1U) == 0) continue;
      if (is_primary(fd(), plane->plane_id)) return {plane->formats, plane->formats + plane->count_formats};
    }
  }
  return {drm_formats().front().code};  // drivers without such planes all have this one
}

bool DrmCard::is_ours() const { return drmIsMaster(fd()) != 0 || drmSetMaster(fd()) == 0; }

CardInfo DrmCard::identity() const {
  return {.path = path_.string(), .driver = driver_, .bus = bus_of(fd())};
}

CardInfo DrmCard::describe(Probe probe) const {
  CardInfo info = identity();
  for (Connector& connector : connectors(probe)) {
    if (info.formats.empty() && !connector.crtcs.empty()) {
      const std::vector<std::uint32_t> offered = formats_of(connector.crtcs.front());
      for (const DrmFormat& format : drm_formats()) {
        if (std::ranges::find(offered, format.code) != offered.end()) info.formats.emplace_back(format.name);
      }
    }
    info.connectors.push_back(std::move(connector.info));
  }
  return info;
}

std::optional<DrmPipe> DrmCard::choose_pipe(const DisplayOptions& options, Probe probe) const {
  const std::vector<Connector> all = connectors(probe);
  std::vector<ConnectorInfo> infos;
  for (const Connector& connector : all) infos.push_back(connector.info);
  const std::optional<std::size_t> chosen = choose_connector(infos, options.connector);
  if (!chosen || all[*chosen].crtcs.empty()) return std::nullopt;

  const Connector& connector = all[*chosen];
  DrmPipe pipe{
      .connector = connector.id, .connector_name = connector.info.name, .crtc = connector.crtcs.front()};
  std::optional<ModeWish> wish;
  if (!options.mode.empty()) wish = parse_mode(options.mode);
  std::optional<std::size_t> mode = choose_mode(connector.info.modes, wish);
  if (!mode) {
    mode = choose_mode(connector.info.modes, std::nullopt);
    pipe.notice = connector.info.name + " has no mode " + options.mode + " and shows " +
                  mode_text(connector.info.modes[*mode]) + "; 'vitrine probe' lists its modes";
  }
  pipe.timing = connector.timings[*mode];
  pipe.mode = connector.info.modes[*mode];
  pipe.format = choose_format(formats_of(pipe.crtc), preferred_bits_, options.format);
  if (pipe.format == nullptr) return std::nullopt;
  if (options.format && pipe.format->kind != *options.format) {
    pipe.notice += (pipe.notice.empty() ? "" : ". ") + path_.string() +
                   " lacks the format asked for and uses " + std::string(pipe.format->name) +
                   "; 'vitrine probe' lists its formats";
  }
  return pipe;
}

std::vector<std::filesystem::path> drm_card_paths() {
  std::vector<std::pair<int, std::filesystem::path>> cards;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/dri", none)) {
    const std::string name = entry.path().filename();
    int number = 0;
    if (!name.starts_with("card")) continue;
    const auto [end, error] = std::from_chars(name.data() + 4, name.data() + name.size(), number);
    if (error == std::errc{} && end == name.data() + name.size()) cards.emplace_back(number, entry.path());
  }
  std::ranges::sort(cards);
  std::vector<std::filesystem::path> paths;
  for (auto& [number, path] : cards) paths.push_back(std::move(path));
  return paths;
}

ScreenInventory list_drm_cards() {
  ScreenInventory inventory;
  for (const std::filesystem::path& path : drm_card_paths()) {
    try {
      inventory.cards.push_back(DrmCard(path).describe(Probe::kAnew));
    } catch (const DisplayUnavailable& error) {
      inventory.cards.push_back({.path = path.string(), .problem = error.what()});
    }
  }
  return inventory;
}

}  // namespace vitrine
