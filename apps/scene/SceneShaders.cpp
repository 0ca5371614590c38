#include "SceneShaders.h"

namespace swellray::scene
{

std::string vertexDeclarations(const std::vector<std::string>& values)
{
  std::string code = "out vec3 place;\nout vec3 normal;\n";
  for (const std::string& value : values)
  {
    code += "in float " + value + "MC;\nout float " + value + ";\n";
  }
  return code;
}

std::string vertexCode(const std::vector<std::string>& values)
{
  std::string code = "place = vertexMC.xyz;\nnormal = normalMC;\n";
  for (const std::string& value : values)
  {
    code += value + " = " + value + "MC;\n";
  }
  return code;
}

std::string fragmentDeclarations(const std::vector<std::string>& values)
{
  std::string code = "in vec3 place;\nin vec3 normal;\n";
  for (const std::string& value : values)
  {
    code += "in float " + value + ";\n";
  }
  return code;
}

std::string sharedFunctions()
{
  return R"(
vec3 perez(float cosZenith, float sunAngle, float cosSun)
{
  return (1.0 + perezA * exp(perezB / max(cosZenith, 0.03))) *
    (1.0 + perezC * exp(perezD * sunAngle) + perezE * cosSun * cosSun);
}

// The model's sky is too yellow and green where the sun is low, and what the sky alone lights is dimmer then.
#define highSun smoothstep(0.05, 0.30, sunDirection.z)
#define duskTint mix(vec3(1.12, 0.80, 0.85), vec3(1.0), highSun)

// Light of the sky from a direction, linear sRGB, kcd/m2.
vec3 skyLight(vec3 direction)
{
  float cosSun = clamp(dot(direction, sunDirection), -1.0, 1.0);
  vec3 value = skyScale * perez(direction.z, acos(cosSun), cosSun);
  float X = value.x * value.y / value.z;
  float Z = value.x * (1.0 - value.y - value.z) / value.z;
  vec3 light = vec3(3.2404542 * X - 1.5371385 * value.x - 0.4985314 * Z,
    -0.9692660 * X + 1.8760108 * value.x + 0.0415560 * Z, 0.0556434 * X - 0.2040259 * value.x + 1.0572252 * Z);
  return max(light, vec3(0.0)) * duskTint;
}

// Through more air the low sun is redder and weaker.
#define sunColor (mix(vec3(0.75, 0.30, 0.10), vec3(1.0, 0.93, 0.80), smoothstep(0.02, 0.35, sunDirection.z)))

// Whole numbers hashed, so that every driver draws the same patches: pcg2d of M. Jarzynski and M. Olano, Journal of
// Computer Graphics Techniques 9(3), 2020.
float hash(vec2 p)
{
  uvec2 v = uvec2(ivec2(p)) * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  return float(v.x >> 8u) / 16777216.0;
}

float noise(vec2 p)
{
  vec2 i = floor(p);
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1.0, 0.0)), f.x),
    mix(hash(i + vec2(0.0, 1.0)), hash(i + vec2(1.0, 1.0)), f.x), f.y);
}

// Octaves of noise, 0 to 1; those that are smaller than a pixel are left out.
float turbulence(vec2 p, float pixel)
{
  float sum = 0.0;
  float weight = 0.5;
  for (int i = 0; i < 5; ++i)
  {
    float seen = 1.0 - smoothstep(0.3, 0.8, pixel);
    sum += weight * mix(0.5, noise(p), seen);
    p = mat2(1.6, 1.2, -1.2, 1.6) * p + 17.0;
    pixel *= 2.0;
    weight *= 0.5;
  }
  return sum / 0.96875;
}

// Slopes of small waves of the wind; of those shorter than some pixels the mean square of their slopes is left.
vec3 rippleSlope(vec2 p, float pixel)
{
  vec2 slope = vec2(0.0);
  float unseen = 0.0;
  float wavelength = rippleLength;
  for (int i = 0; i < 14; ++i)
  {
    float heading = rippleHeading + 1.2 * sin(12.9898 * float(i));
    vec2 k = 6.2831853 / wavelength * vec2(cos(heading), sin(heading));
    float phase = dot(k, p) - sqrt(9.81 * length(k)) * time + 2.399 * float(i);
    float shorter = 4.0 * pixel / wavelength;
    float seen = exp(-shorter * shorter);
    slope += 0.035 * seen * normalize(k) * cos(phase);
    unseen += 0.5 * 0.035 * 0.035 * (1.0 - seen * seen);
    wavelength *= 0.77;
  }
  return vec3(slope, unseen);
}

// Air between the eye and a place.
vec3 throughAir(vec3 light, vec3 ray, float distance)
{
  vec3 level = normalize(vec3(ray.xy, 0.03));
  return mix(skyLight(level), light, exp(-distance / haze));
}

// What a screen shows.
vec4 tone(vec3 light)
{
  // Film: K. Narkowicz's fit (2016) of the curve of the Academy Color Encoding System.
  // Daylight of 5500 K is white, as to a camera, not the bluer one of the screen.
  vec3 x = 0.30 * vec3(0.94, 1.0, 1.06) * light / middle;
  vec3 shown = clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  return vec4(pow(shown, vec3(1.0 / 2.2)), 1.0);
}
)";
}

std::string skyCode()
{
  return R"(
  vec3 ray = normalize(place - eye);
  vec3 light = skyLight(normalize(vec3(ray.xy, max(ray.z, 0.0))));
  float sunDistance = acos(clamp(dot(ray, sunDirection), -1.0, 1.0));
  light += middle * sunColor * 60.0 * (1.0 - smoothstep(0.0046, 0.0060, sunDistance));
  gl_FragData[0] = tone(light);
)";
}

std::string waterCode()
{
  return R"(
  vec3 toEye = eye - place;
  float distance = length(toEye);
  vec3 view = toEye / distance;
  float pixel = length(fwidth(place.xy));
  vec3 up = normalize(normal);
  up = dot(up, view) < 0.0 ? -up : up;
  // Beyond the scene the swell goes on and fades.
  vec2 beyond = place.xy - clamp(place.xy, sceneBounds.xy, sceneBounds.zw);
  float swellPhase = dot(swell.xy, place.xy) - swell.z;
  float swellSeen = length(swell.xy) * pixel;
  float swellRise =
    swell.w * exp(-swellSeen * swellSeen - 0.002 * dot(swell.xy, swell.xy) * dot(beyond, beyond));
  up = normalize(up + vec3(0.6 * swellRise * swell.xy, 0.0) * sin(swellPhase));
  vec3 ripples = rippleSlope(place.xy, pixel);
  vec3 n = normalize(up - vec3(ripples.xy, 0.0) * abs(up.z));
  // Of ripples too small to be seen the eye meets those sides that are turned to it.
  float facing = sqrt(max(dot(n, view), 0.0) * max(dot(n, view), 0.0) + 1.5 * ripples.z + 0.0004);

  // Reflected sky; what ripples would send below the horizon comes from over it.
  vec3 mirror = reflect(-view, n);
  mirror = normalize(vec3(mirror.xy, sqrt(mirror.z * mirror.z + 6.0 * ripples.z + 0.0004)));
  float fresnel = 0.02 + 0.98 * pow(1.0 - min(facing, 1.0), 5.0);
  vec3 reflected = skyLight(mirror);
  float glint = max(dot(mirror, sunDirection), 0.0);
  reflected += sunSeen * middle * sunColor * (30.0 * pow(glint, 900.0) + 1.2 * pow(glint, 60.0));

  // Light out of the water: its own colour, and the sand where it is shallow.
  float sun = max(sunDirection.z, 0.1);
  vec3 deep = middle * vec3(0.008, 0.085, 0.12) * (0.6 + 0.6 * sun * sunSeen);
  vec3 sand = middle * vec3(0.62, 0.52, 0.36) * (0.5 + 0.8 * sun * sunSeen);
  float way = max(bedDepth, 0.0) * (1.0 + 1.0 / max(0.35, view.z));
  vec3 body = mix(deep, sand, exp(-way * vec3(0.55, 0.16, 0.13)));

  // Crests are thin: the sun shines through those that stand between it and the eye.
  float crest = clamp((place.z - waterLevel + swellRise * (1.0 + cos(swellPhase))) / waveHeight, 0.0, 1.2);
  float against = 0.25 + max(0.0, -dot(normalize(view.xy), normalize(sunDirection.xy + 1e-6)));
  body += middle * vec3(0.05, 0.42, 0.34) * 2.0 * crest * crest * against * (0.3 + 0.7 * sunSeen) * (1.0 - 0.6 * abs(up.z));

  vec3 light = mix(body, reflected, fresnel);

  // Foam: patches that shrink as it goes, over finer bubbles.
  vec2 drift = vec2(turbulence(0.35 * place.xy, 0.35 * pixel), turbulence(0.35 * place.yx + 9.0, 0.35 * pixel));
  float patches = turbulence((place.xy + 2.0 * drift) / foamSize, pixel / foamSize);
  float bubbles = turbulence(9.0 * place.xy / foamSize, 9.0 * pixel / foamSize);
  // Noise gathers about its mean: spread it over 0 to 1.
  float grain = clamp(0.5 + 2.4 * (0.7 * patches + 0.3 * bubbles - 0.5), 0.0, 1.0);
  float left = 0.86 * foam;
  float cover = smoothstep(1.0 - left, 1.2 - left, grain) * step(0.004, foam);
  vec3 lit = vec3(1.65, 1.68, 1.7) * duskTint * (0.6 + 0.4 * highSun) + 1.5 * sunSeen * max(dot(up, sunDirection), 0.0) * sunColor;
  light = mix(light, middle * lit * (0.7 + 0.5 * bubbles), 0.95 * cover);

  gl_FragData[0] = tone(throughAir(light, -view, distance));
)";
}

std::string landCode()
{
  return R"(
  vec3 toEye = eye - place;
  float distance = length(toEye);
  vec3 view = toEye / distance;
  float pixel = length(fwidth(place.xy));
  float height = place.z - waterLevel;
  float grain = turbulence(4.0 * place.xy, 4.0 * pixel);
  float spots = turbulence(0.15 * place.xy, 0.15 * pixel);
  vec3 n = normalize(normalize(normal) + vec3(0.06 * (grain - 0.5), 0.06 * (spots - 0.5), 0.0));
  n = n.z < 0.0 ? -n : n;
  float wet = 1.0 - smoothstep(0.15 * waveHeight, 0.75 * waveHeight, height + 0.3 * waveHeight * (spots - 0.5));
  vec3 sand = vec3(0.60, 0.49, 0.35) * (0.82 + 0.36 * grain);
  vec3 grass = vec3(0.13, 0.19, 0.06) * (0.6 + 0.8 * spots);
  float green = smoothstep(2.0 * waveHeight, 3.5 * waveHeight, height + 2.0 * waveHeight * (spots - 0.5));
  // Neither stays on steep faces: rock.
  float steep = 1.0 - smoothstep(0.66, 0.86, normalize(normal).z);
  vec3 rock = vec3(0.30, 0.27, 0.24) * (0.55 + 0.5 * grain + 0.4 * spots);
  vec3 albedo = mix(mix(sand, grass, green), rock, steep) * mix(1.0, 0.5, wet);
  vec3 overhead = skyLight(vec3(0.0, 0.0, 1.0));
  vec3 lit = 3.1 * sunSeen * middle * sunColor * max(dot(n, sunDirection), 0.0) + 0.6 * (overhead + 0.3 * middle);
  vec3 light = albedo * lit;
  vec3 mirror = reflect(-view, normalize(vec3(0.3 * n.xy, n.z)));
  mirror = normalize(vec3(mirror.xy, max(mirror.z, 0.02)));
  float fresnel = 0.02 + 0.98 * pow(1.0 - max(dot(n, view), 0.0), 5.0);
  light = mix(light, skyLight(mirror), 0.75 * wet * fresnel);
  gl_FragData[0] = tone(throughAir(light, -view, distance));
)";
}

std::string sprayCode()
{
  return R"(
  vec3 toEye = eye - place;
  float distance = length(toEye);
  vec3 view = toEye / distance;
  // VTK has an opacity of its own in its shaders, so that of drops has another name.
  // Water in the air scatters most of the light on; drops that fall are in the shade of others (Peachey 1986, section 4.3).
  float through = pow(max(0.0, -dot(view, sunDirection)), 8.0);
  vec3 light = middle * vec3(0.97, 0.99, 1.0) * (2.0 + 1.2 * sunDirection.z + 2.5 * through) * duskTint *
    (0.6 + 0.4 * highSun) * shade;
  float side = 1.0 - across * across;
  float end = 1.0 - along * along;
  gl_FragData[0] = vec4(tone(throughAir(light, -view, distance)).rgb, dropOpacity * side * side * end);
)";
}

}
