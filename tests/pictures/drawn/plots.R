# Plots of R. Usage: Rscript plots.R FOLDER COUNT
words <- commandArgs(TRUE)
for (i in 1:as.integer(words[2])) {
  set.seed(i)
  svg(sprintf("%s/%d.svg", words[1], i), width = 4, height = 3)
  switch(i %% 8 + 1,
         plot(runif(30), pch = i %% 25, col = rainbow(30)),
         hist(rnorm(200), col = "grey"),
         boxplot(count ~ spray, InsectSprays),
         contour(volcano),
         persp(volcano[seq(1, 80, 6), seq(1, 60, 6)], theta = 30, shade = 0.4, col = "lightblue"),
         pie(runif(5)),
         barplot(matrix(runif(6), 2), density = c(10, 30)),
         curve(sin(x) / x, -20, 20, lty = 2, lwd = 3))
  dev.off()
}
