#include "core/lights/light_list.h"

#include <algorithm>
#include <string>

#include "core/text/text_buffer.h"

namespace dapple {

namespace {

void put(TextBuffer& text, const glm::dvec3& v, std::string_view between) {
    text << v.x << between << v.y << between << v.z;
}

// Printable ASCII.
char printable(char c) {
    return c < ' ' || c > '~' ? '?' : c;
}

std::string json_text(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        if (c == '"' || c == '\\') text += '\\';
        text += printable(c);
    }
    return text;
}

// A name within a comment must neither end it nor the line.
std::string comment_text(std::string_view bytes) {
    std::string text = json_text(bytes);
    std::ranges::replace(text, '-', '_');
    return text;
}

// Zeros without a sign.
glm::dvec3 negated(const glm::dvec3& v) {
    return glm::dvec3(0) - v;
}

}  // namespace

glm::dvec3 direction_of(const LightSample& sample, const LightListStyle& style) {
    return turned_about_up(direction_of(sample.uv, style.convention), style.rotation_degrees,
                           style.convention);
}

void write_light_json(std::ostream& out, const LightSamples& lights, const LightListStyle& style) {
    TextBuffer text(out);
    text << "{\n\"convention\": \"" << name_of(style.convention)
         << "\",\n\"rotation_degrees\": " << style.rotation_degrees << ",\n\"source\": \""
         << json_text(style.source) << "\",\n\"position\": \"" << name_of(lights.position)
         << "\",\n\"radiance\": \"" << name_of(lights.radiance)
         << "\",\n\"seed\": " << std::to_string(lights.seed)
         << ",\n\"count\": " << static_cast<std::int64_t>(lights.samples.size()) << ",\n\"total_flux\": [";
    put(text, lights.total_flux, ", ");
    text << "],\n\"samples\": [";
    bool first = true;
    for (const LightSample& sample : lights.samples) {
        text << (first ? "\n{\"direction\": [" : ",\n{\"direction\": [");
        first = false;
        put(text, direction_of(sample, style), ", ");
        text << "], \"u\": " << sample.uv.x << ", \"v\": " << sample.uv.y << ", \"radiance\": [";
        put(text, sample.radiance, ", ");
        text << "], \"pdf\": " << sample.pdf << ", \"weight\": [";
        put(text, sample.weight, ", ");
        text << "]}";
    }
    text << "\n]\n}\n";
    text.flush();
}

void write_light_csv(std::ostream& out, const LightSamples& lights, const LightListStyle& style) {
    TextBuffer text(out);
    std::string source(style.source);
    std::ranges::transform(source, source.begin(), printable);
    text << "# convention: " << name_of(style.convention)
         << "\n# rotation_degrees: " << style.rotation_degrees << "\n# source: " << source
         << "\n# position: " << name_of(lights.position) << "\n# radiance: " << name_of(lights.radiance)
         << "\n# seed: " << std::to_string(lights.seed)
         << "\n# count: " << static_cast<std::int64_t>(lights.samples.size()) << "\n# total_flux: ";
    put(text, lights.total_flux, " ");
    text << '\n';
    text << "x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b\n";
    for (const LightSample& sample : lights.samples) {
        put(text, direction_of(sample, style), ",");
        text << ',' << sample.uv.x << ',' << sample.uv.y << ',';
        put(text, sample.radiance, ",");
        text << ',' << sample.pdf << ',';
        put(text, sample.weight, ",");
        text << '\n';
    }
    text.flush();
}

void write_light_pbrt(std::ostream& out, const LightSamples& lights, const LightListStyle& style) {
    TextBuffer text(out);
    text << "# " << static_cast<std::int64_t>(lights.samples.size()) << " lights from "
         << comment_text(style.source) << ", convention " << name_of(style.convention) << ", turned by "
         << style.rotation_degrees << " degrees; total flux ";
    put(text, lights.total_flux, " ");
    text << "\n";
    for (const LightSample& sample : lights.samples) {
        text << "LightSource \"distant\" \"point3 from\" [ ";
        put(text, direction_of(sample, style), " ");
        text << " ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ ";
        put(text, sample.weight, " ");
        text << " ] \"float scale\" [ 1 ]\n";
    }
    text.flush();
}

void write_light_mitsuba(std::ostream& out, const LightSamples& lights, const LightListStyle& style) {
    TextBuffer text(out);
    text << "<scene version=\"3.0.0\">\n    <!-- " << static_cast<std::int64_t>(lights.samples.size())
         << " lights from " << comment_text(style.source) << ", convention " << name_of(style.convention)
         << ", turned by " << style.rotation_degrees << " degrees; total flux ";
    put(text, lights.total_flux, " ");
    text << " -->\n";
    for (const LightSample& sample : lights.samples) {
        const glm::dvec3 travel = negated(direction_of(sample, style));
        text << "    <emitter type=\"directional\"><vector name=\"direction\" x=\"" << travel.x << "\" y=\""
             << travel.y << "\" z=\"" << travel.z << "\"/><rgb name=\"irradiance\" value=\"";
        put(text, sample.weight, ", ");
        text << "\"/></emitter>\n";
    }
    text << "</scene>\n";
    text.flush();
}

}  // namespace dapple
